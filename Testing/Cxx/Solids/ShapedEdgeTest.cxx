// SPDX-License-Identifier: BSD-3-Clause
// Contacts near the edge of a block, against a full two-dimensional contact with H from another
// code (Data/Reference/shape/edge_axisymmetric_vs_full.csv), and the end of the law at the edge. H
// is the regular part of the Green function (RegularGreen.h).
#include "ShapedBodies.h"

#include "DenseContact.h"
#include "ReferenceTable.h"
#include "TestTools.h"

#include <tuple>

namespace
{
using namespace palpate;
using palpate::testing::ReferenceTable;
using palpate::testing::ShapedBody;

constexpr double EdgeDistance = 3.0;

/// The block of the table, 60 × 60 × 30 mm, with the contact in the middle of a side.
ShapedBody edgeBlock(double side, double ratio, double radius = 5.0)
{
  VolumeMesh mesh =
    palpate::testing::gridBlock(palpate::testing::gradedHalf(side, 2.0 * EdgeDistance, ratio, 60.0),
      palpate::testing::gradedLine(side, 3.75, ratio, 30.0),
      palpate::testing::gradedDepth(side, EdgeDistance, ratio, 30.0));
  const std::vector<unsigned char> fixed = palpate::testing::heldBelow(mesh);
  return ShapedBody({ std::move(mesh), { { 1.0, 0.45 } }, fixed },
    Eigen::Vector3d(EdgeDistance, 0.0, 30.0), radius);
}
} // namespace

// Contacts up to a/e = 0.83. The law ignores angular harmonics from the second on: 0.6 % of the
// force on the widest flat end, less for the other tools. Elements of e/4 have an error of 1 % of
// C_g, which is 0.3 % of the force.
TEST(ShapedEdge, FollowsTheFullContact)
{
  const ShapedBody block = edgeBlock(0.75, 1.25);
  const ReferenceTable table("shape/edge_axisymmetric_vs_full.csv");
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    std::string name = table.text(i, "tool");
    name.insert(name.find_first_of("0123456789"), ":");
    const auto pressed = palpate::testing::tool(name);
    const ContactCurve curve = ShapedContact(*pressed).curve(*block.fit);
    const double depth = table.number(i, "delta");
    const double error = curve.evaluate(depth).force / table.number(i, "full 2-D: F") - 1.0;
    const bool flat = name[0] == 'f';
    EXPECT_LT(std::abs(error), flat ? 0.01 : 0.005) << name << " " << depth;
    // By the table, the tilt's part of the force is the error of a law without tilt.
    const IndentationPoint found = curve.evaluate(depth);
    const double part = curve.errorsAt(depth).harmonics * found.stiffness * depth / found.force;
    const double missed = -0.01 * table.number(i, "axisymmetric error %");
    EXPECT_NEAR(part, missed, 0.15 * missed) << name << " " << depth;
  }
}

// A dense contact with the same H and without means over angles, so it includes the tilt. The
// difference is the error of the law: 0.6 % for the widest flat end. The error of the square cells
// is the same on a half-space, where the closed form removes it.
TEST(ShapedEdge, IsWhatAllHarmonicsGive)
{
  const ShapedBody block = edgeBlock(1.0, 1.6, 2.6);
  for (const auto& [name, depth, tolerance] :
    { std::tuple("flat:1.5", 1.0, 0.002), std::tuple("flat:2.5", 1.0, 0.008),
      std::tuple("sphere:6.35", 0.6, 0.003), std::tuple("sphere:6.35", 1.0, 0.005) })
  {
    const auto pressed = palpate::testing::tool(name);
    const ContactCurve curve = ShapedContact(*pressed).curve(*block.fit);
    const double radius = curve.evaluate(depth).contactRadius;
    const palpate::testing::DenseContact dense(*block.fit, 1.25 * radius, radius / 9.0);
    const auto gap = [&](double r) { return pressed->profile(r); };
    // The force on the half-space at the depth with the same contact radius.
    const bool flat = pressed->smallestContactRadius() > 0.0;
    const double alone = flat ? depth : pressed->depthAtContactRadius(radius);
    const double cells =
      dense.force(alone, gap, false) / pressed->force(alone, block.fit->site().reducedModulus);
    const double expected = dense.force(depth, gap, true) / cells;
    EXPECT_NEAR(curve.evaluate(depth).force / expected, 1.0, tolerance) << name << " " << depth;
  }
}

TEST(ShapedEdge, EndsTheCurve)
{
  const ShapedBody block = edgeBlock(1.5, 1.6);
  EXPECT_NEAR(block.fit->site().largestRadius, EdgeDistance, 1e-9);
  EXPECT_EQ(block.fit->site().limitedBy, PatchStatus::Edge);
  const auto wide = palpate::testing::tool("flat:3.5");
  const ContactCurve none = ShapedContact(*wide).curve(*block.fit);
  EXPECT_TRUE(none.isEmpty());
  EXPECT_EQ(none.end(), CurveEnd::Edge);
  EXPECT_TRUE(std::isnan(none.evaluate(0.1).force));
  const auto sphere = palpate::testing::tool("sphere:6.35");
  const ContactCurve curve = ShapedContact(*sphere).curve(*block.fit);
  EXPECT_EQ(curve.end(), CurveEnd::Edge);
  EXPECT_NEAR(curve.samples().back().radius, EdgeDistance, 1e-6);
  EXPECT_TRUE(std::isnan(curve.evaluate(1.01 * curve.deepest()).force));
}
