// SPDX-License-Identifier: BSD-3-Clause
// Tables of tilts on a half-space, and their interpolation between nodes.
#include "Mechanics/ThreadCount.h"
#include "Mechanics/Tilt/TiltNodes.h"
#include "Mechanics/Tilt/TiltedContact.h"
#include "Mechanics/Tilt/TiltedFlat.h"

#include "Agreement.h"
#include "ReferenceTable.h"
#include "TestTools.h"
#include "TiltReference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace palpate::testing
{
namespace
{
/// Compares a table with the forces and torques of the other solver, at angles between the nodes.
void compare(const std::string& name, double range, double largest, double leastDepth,
  double forceTolerance, double torqueTolerance)
{
  const auto shape = tool(tiltedToolOf(name));
  const MadeTilt made = makeTiltTable(*shape, range, largest, { TiltBody() });
  ASSERT_EQ(made.fault, "");
  const ReferenceTable table("tilt/tilt_bem.csv");
  int rows = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double depth = table.number(row, "D");
    const double angle = table.number(row, "theta_deg") * Degree;
    if (table.text(row, "tool") != name || depth > range || depth < leastDepth ||
      angle > largest * (1.0 + 1e-9) || angle == 0.0)
    {
      continue;
    }
    const FeltTilt felt = feltBy(made.table, *shape, {}, depth, angle);
    const double force = table.number(row, "F_over_Estar");
    EXPECT_TRUE(agrees(felt.force, force, forceTolerance)) << name << ' ' << depth << ' ' << angle;
    // At small tilts the torque is a small difference of terms of the size F times offset.
    const double torque = table.number(row, "Mtip_work");
    const double left = 0.005 * force * made.table.deepest(angle).offset;
    EXPECT_NEAR(felt.torque, torque, std::max(left, torqueTolerance * torque))
      << name << ' ' << depth << ' ' << angle;
    ++rows;
  }
  EXPECT_GE(rows, 5);
  // At a tilt near zero the torque vanishes, to 1e-3 of F a.
  const double small = 1e-5;
  const FeltTilt felt = feltBy(made.table, *shape, {}, 0.6 * range, small);
  EXPECT_LT(std::abs(felt.torque), 1e-3 * felt.force * shape->contactRadius(0.6 * range));
}
} // namespace

TEST(TiltNodes, ASphereIsFeltAsUpright)
{
  const auto sphere = tool("sphere:3");
  const MadeTilt made = makeTiltTable(*sphere, 1.0, 60.0 * Degree, { TiltBody() });
  ASSERT_EQ(made.fault, "");
  for (const double depth : { 1e-3, 0.2, 1.0, 1.4 })
  {
    for (const double angle : { 1e-4, 0.3, 1.0 })
    {
      const FeltTilt felt = feltBy(made.table, *sphere, {}, depth, angle);
      const double force = sphere->force(depth, 1.0);
      EXPECT_TRUE(agrees(felt.force, force, 1e-12));
      // h is interpolated from 65 nodes: its error is (width)⁴/384, that of its slope (width)³/125.
      EXPECT_NEAR(made.table.deepest(angle).drop, 3.0 * (1.0 - std::cos(angle)), 1e-8);
      EXPECT_TRUE(agrees(felt.torque, force * 3.0 * std::sin(angle), 4e-5));
    }
  }
}

TEST(TiltNodes, AFlatEndHasItsLaw)
{
  const auto flat = tool("flat:1.5");
  const MadeTilt made = makeTiltTable(*flat, 1.0, 40.0 * Degree, { TiltBody() });
  ASSERT_EQ(made.fault, "");
  for (const double angle : { 0.001, 0.02, 0.1, 0.35 })
  {
    const double rim = 1.5 * std::sin(angle);
    for (const double depth : { 0.02, 0.1, 0.3, 0.9, 1.0 })
    {
      const FeltTilt felt = feltBy(made.table, *flat, {}, depth, angle);
      const double q = depth / rim;
      // Error of the equivalent profile and the nodes: 1e-5 of the upright force. In full contact
      // the law is exact.
      EXPECT_NEAR(
        felt.force, 2.0 * 1.5 * rim * tiltedFlatForce(q).value, 1e-5 * flat->force(depth, 1.0))
        << depth << ' ' << angle;
      if (q >= 3.0)
      {
        EXPECT_TRUE(agrees(felt.force, 2.0 * 1.5 * (depth - rim), 3e-5));
        EXPECT_NEAR(felt.torque, 4.0 / 3.0 * std::pow(1.5, 3.0) * std::sin(angle) * std::cos(angle),
          1e-4 * felt.force);
      }
    }
  }
}

// The force of cones has an error of 0.5 %. Their torque is a derivative over the angle, where the
// tables are steep: 1 %.
TEST(TiltNodes, AConeIsThatOfBoundaryElements)
{
  compare("cone60", 1.0, 25.0 * Degree, 0.0, 5e-3, 1e-2);
}

// The force of blunted cones has an error of 0.5 %.
TEST(TiltNodes, ABluntedConeIsThatOfBoundaryElements)
{
  compare("blunt45", 1.0, 28.0 * Degree, 0.0, 5e-3, 1e-2);
}

// Other tools with a flat end: an error of 1 % of the force from a depth of 0.2 on, 3 % of the
// torque.
TEST(TiltNodes, ATruncatedConeIsThatOfBoundaryElements)
{
  compare("trunc45", 1.0, 28.0 * Degree, 0.2, 1e-2, 3e-2);
}

TEST(TiltNodes, ASampledProfileIsThatOfBoundaryElements)
{
  // The facets of the profile reach full contact one after the other, between 4° and 25°. At these
  // tilts the tool acts nearly as a cone in full contact. Between these tilts the error is 1 %.
  const auto shape = tool("profile:0,0;0.3,0.0225;0.6,0.09;1,0.26;1.5,0.65;2,1.4");
  const MadeTilt made = makeTiltTable(*shape, 0.5, 20.0 * Degree, { TiltBody() });
  ASSERT_EQ(made.fault, "");
  for (const double angle : { 7.5 * Degree, 17.0 * Degree })
  {
    for (const double depth : { 0.1, 0.3 })
    {
      const double solved = solveTilted(*shape, angle, depth).perModulus;
      EXPECT_TRUE(agrees(feltBy(made.table, *shape, {}, depth, angle).force, solved, 0.01))
        << angle / Degree << ' ' << depth;
    }
  }
}

TEST(TiltNodes, DerivativesAreThoseOfTheFactor)
{
  const auto flat = tool("flat:1");
  const TiltBody soft{ 0.0, nullptr, 0.4 };
  const MadeTilt made = makeTiltTable(*flat, 1.0, 40.0 * Degree, { TiltBody(), soft });
  ASSERT_EQ(made.fault, "");
  const double weights[] = { 0.3, 0.7 };
  for (const double depth : { 0.013, 0.21, 0.77 })
  {
    for (const double angle : { 0.011, 0.17, 0.6 })
    {
      const TiltFactor at = made.table.at(depth, angle, weights);
      // Error of central differences of a cubic: the square of step / cell, 1e-6 of the largest
      // value.
      const double step = 1e-4 * depth;
      const TiltFactor less = made.table.at(depth - step, angle, weights);
      const TiltFactor more = made.table.at(depth + step, angle, weights);
      EXPECT_NEAR((more.value - less.value) / (2.0 * step), at.byDepth, 1e-6 / depth);
      EXPECT_NEAR(
        (more.byDepth - less.byDepth) / (2.0 * step), at.byDepthTwice, 1e-6 / (depth * depth));
      const double turn = 1e-4 * angle;
      EXPECT_NEAR((made.table.at(depth, angle + turn, weights).value -
                    made.table.at(depth, angle - turn, weights).value) /
          (2.0 * turn),
        at.byAngle, 1e-6 / angle);
    }
  }
}

TEST(TiltNodes, GivesTheSameBitsOnAnyNumberOfThreads)
{
  const auto cone = tool("cone:60");
  const auto nodesOn = [&](std::size_t threads)
  {
    const ThreadLimit limit(threads);
    return makeTiltTable(*cone, 1.0, 10.0 * Degree, { TiltBody() }).table.nodes();
  };
  const std::vector<double> one = nodesOn(1);
  EXPECT_FALSE(one.empty());
  EXPECT_EQ(one, nodesOn(2));
  EXPECT_EQ(one, nodesOn(8));
}

TEST(TiltNodes, SaysWhatCannotBe)
{
  const auto cone = tool("cone:60");
  const auto faultOf = [&](double range, double largest, const std::vector<TiltBody>& bodies)
  { return makeTiltTable(*cone, range, largest, bodies).fault; };
  EXPECT_NE(faultOf(1.0, 28.0 * Degree, { TiltBody() }).find("28 degrees"), std::string::npos);
  EXPECT_NE(faultOf(-1.0, 0.2, { TiltBody() }).find("-1"), std::string::npos);
  EXPECT_NE(faultOf(1.0, 0.2, {}).find("but is 0"), std::string::npos);
  EXPECT_NE(faultOf(1.0, 0.2, std::vector<TiltBody>(TiltTerms::MostLaws + 1)).find("but is 17"),
    std::string::npos);
  // A ring next to the tip comes into contact at larger depths.
  const auto ring = tool("profile:0,0;1,1;2,0.05;3,3");
  const std::string fault = makeTiltTable(*ring, 2.0, 0.2, { TiltBody() }).fault;
  EXPECT_NE(fault.find("touches the body again"), std::string::npos) << fault;
}
} // namespace palpate::testing
