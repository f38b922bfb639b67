// SPDX-License-Identifier: BSD-3-Clause
// A body under unit loads at a place. Far from the loads it moves as under any other loads of the
// same resultant. A part that is cut out of the body moves as in the whole body if it is loaded by
// the forces at the cut.
#include "Solids/FiniteElements/UnitLoads.h"
#include "Solids/ShapedBodies.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <utility>

namespace
{
using namespace palpate;
using namespace palpate::testing;

/// A bar of 12 × 3 × 3 mm, held at x = 0.
VolumeMesh bar(bool isOfTetrahedra)
{
  const std::vector<double> along = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 };
  const std::vector<double> across = { 0, 1, 2, 3 };
  const VolumeMesh mesh = gridBlock(along, across, across);
  return isOfTetrahedra ? quadratic(tetrahedra(mesh)) : mesh;
}

void solve(VolumeMesh mesh, double heldUpTo, ElasticBody& body)
{
  ElasticBodyInput input;
  input.fixed = heldTo(mesh, heldUpTo);
  input.mesh = std::move(mesh);
  input.materials = { { 0.1, 0.4 } };
  ASSERT_EQ(body.assemble(std::move(input)), "");
  ASSERT_EQ(body.analyse(StiffnessFactor::Kind::Automatic), "");
  ASSERT_EQ(body.factorise(), "");
}

/// The local coordinates of an element's centre.
ElementPlace inMiddle(const VolumeMesh& mesh, std::int32_t element)
{
  const bool isHexahedron =
    mesh.elements[static_cast<std::size_t>(element)].kind == ElementKind::Hexahedron;
  return { element, Eigen::Vector3d::Constant(isHexahedron ? 0.0 : 0.25) };
}

/// Equal to rounding, because the elements are the same.
TEST(UnitLoads, APartMovesAsItDoesInTheWhole)
{
  for (const bool isOfTetrahedra : { false, true })
  {
    ElasticBody whole;
    solve(bar(isOfTetrahedra), 0.0, whole);
    std::vector<std::int32_t> nodes;
    const VolumeMesh cut = partBeyond(whole.mesh(), 6.0, nodes);
    ElasticBody part;
    solve(cut, 6.0, part);
    const Eigen::Vector3d place(9.4, 1.3, 3.0);
    const UnitMotion inWhole =
      unitMotion(whole, place, inMiddle(whole.mesh(), elementAt(whole.mesh(), place)));
    UnitMotion ofCut = inWhole;
    for (Eigen::Matrix3Xd& moved : ofCut.nodes)
    {
      moved = Eigen::Matrix3Xd(moved(Eigen::all, nodes));
    }
    const UnitMotion rest = motionFromCut(part, ofCut);
    const UnitMotion local = unitMotion(part, place, inMiddle(cut, elementAt(cut, place)));
    for (std::size_t k = 0; k < 6; ++k)
    {
      const Eigen::Matrix3Xd expected = inWhole.nodes[k](Eigen::all, nodes);
      const double off = (local.nodes[k] + rest.nodes[k] - expected).cwiseAbs().maxCoeff();
      EXPECT_LT(off, 1e-9 * expected.cwiseAbs().maxCoeff()) << k;
      EXPECT_GT(local.nodes[k].cwiseAbs().maxCoeff(), 0.01 * expected.cwiseAbs().maxCoeff()) << k;
    }
  }
}

/// At two widths from the loads, a force on one node and a couple on two nodes have the same effect
/// to a hundredth (St. Venant).
TEST(UnitLoads, FarAwayOnlyTheResultantCounts)
{
  ElasticBody body;
  solve(bar(true), 0.0, body);
  const VolumeMesh& mesh = body.mesh();
  const auto nodeAt = [&](const Eigen::Vector3d& place)
  {
    Eigen::Index found = 0;
    (mesh.nodes.colwise() - place).colwise().squaredNorm().minCoeff(&found);
    return found;
  };
  const Eigen::Vector3d place(11.0, 1.0, 3.0);
  const UnitMotion motion = unitMotion(
    body, place, inMiddle(mesh, elementAt(mesh, place + Eigen::Vector3d(0.3, 0.3, -0.4))));
  for (int k = 0; k < 6; ++k)
  {
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, mesh.nodes.cols());
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(k % 3);
    if (k < 3)
    {
      forces.col(nodeAt(place)) = unit;
    }
    else
    {
      // both ends of the arm are nodes
      const Eigen::Vector3d arm = Eigen::Vector3d::Unit((k + 1) % 3);
      const Eigen::Vector3d low = place - (arm[2] > 0.0 ? 1.0 : 0.0) * arm;
      const Eigen::Vector3d push = unit.cross(arm);
      forces.col(nodeAt(low + arm)) += push;
      forces.col(nodeAt(low)) -= push;
    }
    const Eigen::Matrix3Xd expected = body.displacement(forces);
    double off = 0.0;
    double most = 0.0;
    for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
    {
      if (mesh.nodes(0, i) <= 5.0)
      {
        off = std::max(
          off, (motion.nodes[static_cast<std::size_t>(k)].col(i) - expected.col(i)).norm());
        most = std::max(most, expected.col(i).norm());
      }
    }
    EXPECT_LT(off, 0.01 * most) << k;
  }
}
} // namespace
