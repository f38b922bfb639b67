// SPDX-License-Identifier: BSD-3-Clause
// A patch of pressure on the surface of a mesh, and the half-space with which it is compared.
#include "Agreement.h"
#include "ElasticBlocks.h"
#include "Solids/FiniteElements/HalfSpaceField.h"
#include "Solids/FiniteElements/PatchLoad.h"
#include "Mechanics/Numerics/Constants.h"

#include <cmath>

namespace
{
using namespace palpate;
using palpate::Pi;
using palpate::testing::agrees;

struct Block
{
  explicit Block(VolumeMesh made)
    : mesh(std::move(made))
  {
    this->topology.build(this->mesh);
    this->surface = BodySurface(this->mesh, this->topology);
  }
  VolumeMesh mesh;
  MeshTopology topology;
  BodySurface surface;
};
} // namespace

TEST(DiscRule, MomentsOfAUniformDisc)
{
  const DiscRule& rule = DiscRule::standard();
  for (int p = 0; p <= 5; ++p)
  {
    for (int q = 0; p + q <= 5; ++q)
    {
      double sum = 0.0;
      for (std::size_t i = 0; i < DiscRule::Count; ++i)
      {
        sum += rule.weights[i] * std::pow(rule.at[i][0], p) * std::pow(rule.at[i][1], q);
      }
      // The mean of x^p y^q over the unit disc is zero unless both powers are even.
      const double exact = p % 2 || q % 2 ? 0.0
                                          : 2.0 / (p + q + 2) * std::tgamma(0.5 * (p + 1)) *
          std::tgamma(0.5 * (q + 1)) / (Pi * std::tgamma(0.5 * (p + q + 2)));
      EXPECT_NEAR(sum, exact, 1e-15) << p << " " << q; // 1e-15: rounding
    }
  }
}

TEST(PatchLoad, SumsToOneNewtonAboutThePoint)
{
  const VolumeMesh hexahedra = palpate::testing::hexahedronBlock(6, 6, 3, 1.0);
  const VolumeMesh linear = palpate::testing::tetrahedra(hexahedra);
  for (const VolumeMesh& mesh : { hexahedra, linear, palpate::testing::quadratic(linear) })
  {
    const Block block(mesh);
    const std::int32_t point =
      palpate::testing::pointAt(block.surface, Eigen::Vector3d(3.0, 3.0, 3.0));
    const PatchLoad load = makePatchLoad(block.mesh, block.surface, point, 1.5);
    ASSERT_TRUE(load.complete);
    double sum = 0.0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (const auto& [node, share] : load.nodes)
    {
      sum += share;
      moment += share * block.mesh.nodes.col(node);
      EXPECT_EQ(block.mesh.nodes(2, node), 3.0);
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_NEAR((moment - Eigen::Vector3d(3.0, 3.0, 3.0)).norm(), 0.0, 1e-14);
    double spread = 0.0;
    for (std::size_t q = 0; q < DiscRule::Count; ++q)
    {
      spread += DiscRule::standard().weights[q] *
        (load.places[q] - block.surface.position(point)).squaredNorm();
    }
    EXPECT_TRUE(agrees(spread, 0.5 * 1.5 * 1.5, 1e-13)); // the mean r² of a disc is c²/2
  }
}

TEST(PatchLoad, DoesNotWrapAnEdge)
{
  const Block block(palpate::testing::hexahedronBlock(6, 6, 3, 1.0));
  const auto complete = [&](double x, double y, double radius)
  {
    const std::int32_t point = palpate::testing::pointAt(block.surface, Eigen::Vector3d(x, y, 3.0));
    return makePatchLoad(block.mesh, block.surface, point, radius).complete;
  };
  EXPECT_TRUE(complete(1.0, 3.0, 1.0));
  EXPECT_FALSE(complete(1.0, 3.0, 1.2)); // the outermost ring of the rule is at 0.94 of the radius
  EXPECT_FALSE(complete(0.0, 3.0, 0.5)); // on the edge
  EXPECT_FALSE(complete(0.0, 0.0, 0.5)); // at a corner
}

TEST(BodySurface, IsClosedAndFacesOut)
{
  const VolumeMesh hexahedra = palpate::testing::hexahedronBlock(3, 4, 2, 0.5);
  const VolumeMesh linear = palpate::testing::tetrahedra(hexahedra);
  for (const VolumeMesh& mesh : { hexahedra, linear, palpate::testing::quadratic(linear) })
  {
    const Block block(mesh);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double area = 0.0;
    double volume = 0.0;
    for (std::int32_t t = 0; t < block.surface.triangleTotal(); ++t)
    {
      const double share = block.surface.triangleArea(t);
      sum += share * block.surface.triangleNormal(t);
      area += share;
      volume += share / 3.0 *
        block.surface.triangleNormal(t).dot(block.surface.position(block.surface.triangle(t)[0]));
    }
    EXPECT_NEAR(sum.norm(), 0.0, 1e-14);
    EXPECT_NEAR(area, 2.0 * (1.5 * 2.0 + 2.0 * 1.0 + 1.0 * 1.5), 1e-13);
    EXPECT_NEAR(volume, 3.0, 1e-13);
    const std::int32_t top =
      palpate::testing::pointAt(block.surface, Eigen::Vector3d(0.5, 1.0, 1.0));
    EXPECT_NEAR((block.surface.normal(top) - Eigen::Vector3d(0, 0, 1)).norm(), 0.0, 1e-14);
  }
}

// Boussinesq's field: displacements at the surface, and equilibrium inside by central differences.
TEST(HalfSpaceField, SurfaceAndEquilibrium)
{
  const double nu = 0.3;
  const Eigen::Vector3d above = boussinesqDisplacement({ 3.0, 4.0, 0.0 }, nu);
  EXPECT_TRUE(agrees(above[2], (1.0 - nu * nu) / (Pi * 5.0), 1e-14));
  // Reference, section 1: u_r = -(1-2ν)/(2π(1-ν)E*) F/r.
  EXPECT_TRUE(agrees(above.head<2>().norm(),
    (1.0 - 2.0 * nu) * (1.0 - nu * nu) / (2.0 * Pi * (1.0 - nu) * 5.0), 1e-14));
  EXPECT_LT(above[0], 0.0); // the motion is towards the force

  const Eigen::Vector3d at(0.7, -0.4, 0.9);
  const double h = 1e-3;
  const auto u = [&](const Eigen::Vector3d& x) { return boussinesqDisplacement(x, nu); };
  const auto second = [&](int i, int j) -> Eigen::Vector3d
  {
    const Eigen::Vector3d a = h * Eigen::Vector3d::Unit(i);
    const Eigen::Vector3d b = h * Eigen::Vector3d::Unit(j);
    return (u(at + a + b) - u(at + a - b) - u(at - a + b) + u(at - a - b)) / (4.0 * h * h);
  };
  for (int i = 0; i < 3; ++i)
  {
    double navier = 0.0; // (1-2ν) ∇²u_i + ∂_i div u
    for (int j = 0; j < 3; ++j)
    {
      navier += (1.0 - 2.0 * nu) * second(j, j)[i] + second(i, j)[j];
    }
    EXPECT_NEAR(navier, 0.0, 1e-5); // error of the differences: h² times the fourth derivatives
  }
}
