// SPDX-License-Identifier: BSD-3-Clause
// Single elements: rigid motions, homogeneous strain, inversion; and the patch test.
#include "Agreement.h"
#include "ElasticBlocks.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace elastic_element
{
namespace
{
using namespace palpate;
using palpate::testing::agrees;

constexpr ElasticMaterial Material{ 2.0, 0.3 };

/// A block of one distorted hexahedron, of six tetrahedra, or of six quadratic tetrahedra.
VolumeMesh distorted(ElementKind kind)
{
  VolumeMesh cube = palpate::testing::hexahedronBlock(1, 1, 1, 2.0);
  for (Eigen::Index i = 0; i < 8; ++i)
  {
    const double t = static_cast<double>(i);
    cube.nodes.col(i) += 0.2 * Eigen::Vector3d(std::sin(3 * t), std::cos(5 * t), std::sin(7 * t));
  }
  if (kind == ElementKind::Hexahedron)
  {
    return cube;
  }
  const VolumeMesh linear = palpate::testing::tetrahedra(cube);
  return kind == ElementKind::Tetrahedron ? linear : palpate::testing::quadratic(linear);
}

constexpr std::array<ElementKind, 3> Kinds = { ElementKind::Hexahedron, ElementKind::Tetrahedron,
  ElementKind::QuadraticTetrahedron };

/// A displacement that is linear in space, and its energy density ½ σ:ε by Hooke's law.
struct Stretch
{
  Eigen::Matrix3d gradient =
    (Eigen::Matrix3d() << 0.3, -0.2, 0.1, 0.5, -0.1, 0.4, 0.2, 0.3, 0.6).finished();

  double energyDensity(const ElasticMaterial& material) const
  {
    const Eigen::Matrix3d strain = 0.5 * (this->gradient + this->gradient.transpose());
    const double shear = material.youngsModulus / (2.0 * (1.0 + material.poissonRatio));
    const double lame = 2.0 * shear * material.poissonRatio / (1.0 - 2.0 * material.poissonRatio);
    return 0.5 * lame * strain.trace() * strain.trace() + shear * strain.squaredNorm();
  }
};
} // namespace

TEST(ElasticElement, SixRigidMotionsAndNoOthersAreFree)
{
  for (const ElementKind kind : Kinds)
  {
    const VolumeMesh mesh = distorted(kind);
    ElementMatrix k;
    ASSERT_TRUE(elementStiffness(kind, elementNodes(mesh, mesh.elements[0]), Material, k));
    ASSERT_EQ(k.rows(), 3 * nodeCount(kind));
    EXPECT_LT((k - k.transpose()).norm(), 1e-14 * k.norm());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum{ Eigen::MatrixXd(k) };
    const auto& values = spectrum.eigenvalues();
    EXPECT_LT(values.head(6).cwiseAbs().maxCoeff(), 1e-13 * values.maxCoeff()); // 1e-13: rounding
    EXPECT_GT(values[6], 1e-3 * values.maxCoeff());
  }
}

TEST(ElasticElement, EnergyOfHomogeneousStrain)
{
  const Stretch stretch;
  for (const ElementKind kind : { ElementKind::Tetrahedron, ElementKind::QuadraticTetrahedron })
  {
    const VolumeMesh mesh = distorted(kind);
    const ElementNodes x = elementNodes(mesh, mesh.elements[0]);
    ElementMatrix k;
    ASSERT_TRUE(elementStiffness(kind, x, Material, k));
    const ElementNodes moved = stretch.gradient * x;
    const Eigen::Map<const Eigen::VectorXd> u(moved.data(), moved.size());
    Eigen::Matrix3d edges;
    edges << x.col(1) - x.col(0), x.col(2) - x.col(0), x.col(3) - x.col(0);
    const double volume = edges.determinant() / 6.0;
    EXPECT_TRUE(
      // 1e-13: rounding
      agrees(0.5 * u.dot(k * u), volume * stretch.energyDensity(Material), 1e-13));
  }
}

// The patch test: eight elements around a displaced node. If all nodes move linearly, the inner
// node has no force, and the energy is exact.
TEST(ElasticElement, PatchTest)
{
  const Stretch stretch;
  for (const ElementKind kind : Kinds)
  {
    VolumeMesh mesh = palpate::testing::hexahedronBlock(2, 2, 2, 1.0);
    mesh.nodes.col(13) += Eigen::Vector3d(0.2, -0.15, 0.1); // the inner node
    if (kind != ElementKind::Hexahedron)
    {
      mesh = palpate::testing::tetrahedra(mesh);
    }
    if (kind == ElementKind::QuadraticTetrahedron)
    {
      mesh = palpate::testing::quadratic(mesh);
    }
    MeshTopology topology;
    ASSERT_EQ(topology.build(mesh), "");
    StiffnessMatrix stiffness;
    const std::vector<unsigned char> free(static_cast<std::size_t>(mesh.nodeTotal()), 0);
    ASSERT_EQ(assembleStiffness(mesh, topology, { Material }, free, stiffness), "");
    const Eigen::Matrix3Xd moved = stretch.gradient * mesh.nodes;
    const Eigen::Map<const Eigen::VectorXd> u(moved.data(), moved.size());
    const Eigen::VectorXd force = stiffness.lower.selfadjointView<Eigen::Lower>() * u;
    EXPECT_LT(force.segment<3>(39).norm(), 1e-12 * force.norm()); // 1e-12: rounding
    EXPECT_TRUE(agrees(0.5 * u.dot(force), 8.0 * stretch.energyDensity(Material), 1e-12));
  }
}

TEST(ElasticElement, InvertedOnesAreRefused)
{
  for (const ElementKind kind : Kinds)
  {
    const VolumeMesh mesh = distorted(kind);
    ElementNodes x = elementNodes(mesh, mesh.elements[0]);
    EXPECT_GT(smallestJacobian(kind, x), 0.0);
    x.row(2) = -x.row(2); // a mirror image
    ElementMatrix k;
    EXPECT_FALSE(elementStiffness(kind, x, Material, k));
    EXPECT_LT(smallestJacobian(kind, x), 0.0);
    x.row(2).setZero();
    EXPECT_FALSE(elementStiffness(kind, x, Material, k));
  }
}

// A slender bar of cubes bends as a beam. Without the incompatible modes it would be half as stiff
// again (shear locking).
TEST(ElasticElement, HexahedraBend)
{
  const int length = 16;
  const VolumeMesh mesh = palpate::testing::hexahedronBlock(1, 1, length, 1.0);
  ElasticBody body;
  ASSERT_EQ(body.assemble({ mesh, { { 1.0, 0.0 } }, palpate::testing::heldBelow(mesh) }), "");
  ASSERT_EQ(body.analyse(StiffnessFactor::Kind::Simplicial), "");
  ASSERT_EQ(body.factorise(), "");
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, mesh.nodes.cols());
  forces.row(0).tail(4).setConstant(0.25);
  const double moved = body.displacement(forces)(0, mesh.nodes.cols() - 1);
  // L³/(3EI) + 6L/(5GA), Timoshenko; I = 1/12, G = 1/2.
  const double beam = 4.0 * length * length * length + 2.4 * length;
  EXPECT_TRUE(agrees(moved, beam, 0.01)); // error for a beam of 16 cubes, one cube thick
}
} // namespace elastic_element
