// SPDX-License-Identifier: BSD-3-Clause
// Tilted tools on layers, by their equivalent profiles.
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/SeriesCompliance.h"
#include "Mechanics/Tilt/TiltError.h"
#include "Mechanics/Tilt/TiltGeometry.h"
#include "Mechanics/Tilt/TiltNodes.h"

#include "Agreement.h"
#include "ReferenceTable.h"
#include "TestTools.h"
#include "TiltReference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace palpate::testing
{
namespace
{
std::shared_ptr<const LayerKernel> bonded()
{
  static const auto kernel = std::make_shared<const LayerKernel>(0.45, LayerBase::Bonded);
  return kernel;
}

/// Compares tables for the layers of the reference with the forces of the reference. The tolerance
/// is the sum of the expected error of the equivalent profile, the error of the table and that of
/// the upright force on the reference's grid.
void compare(const std::string& name, double range, double largest, double tableError)
{
  const auto shape = tool(tiltedToolOf(name));
  const ReferenceTable reference("tilt/tilt_layer_nu0.45.csv");
  std::vector<TiltBody> bodies;
  for (std::size_t row = 0; row < reference.size(); ++row)
  {
    const double thickness = reference.number(row, "h");
    const bool isNew = std::none_of(bodies.begin(), bodies.end(),
      [&](const TiltBody& body) { return body.thickness == thickness; });
    if (isNew && reference.text(row, "tool") == name && reference.number(row, "D") == range)
    {
      bodies.push_back({ thickness, bonded(), 0.0 });
    }
  }
  const MadeTilt made = makeTiltTable(*shape, range, largest, bodies);
  ASSERT_EQ(made.fault, "");
  int rows = 0;
  double worst = 0.0;
  for (std::size_t row = 0; row < reference.size(); ++row)
  {
    const double angle = reference.number(row, "theta_deg") * Degree;
    if (reference.text(row, "tool") != name || reference.number(row, "D") != range ||
      angle == 0.0 || angle > largest * (1.0 + 1e-9))
    {
      continue;
    }
    const double depth = reference.number(row, "D");
    const auto body = std::find_if(bodies.begin(), bodies.end(),
      [&](const TiltBody& each) { return each.thickness == reference.number(row, "h"); });
    std::vector<double> weights(bodies.size(), 0.0);
    weights[static_cast<std::size_t>(body - bodies.begin())] = 1.0;
    const TiltFactor tau = made.table.at(depth, angle, weights.data());
    const TiltWork upright = pressedInto(*shape, *body, depth);
    const double force = upright.force * tau.value + upright.work * tau.byDepth;
    const double expected =
      tiltError({ reference.number(row, "a_over_h_upright"), force / upright.force,
        made.table.terms().dropScale * made.table.deepest(angle).drop / depth });
    const double error = force / reference.number(row, "F_over_Estar") - 1.0;
    EXPECT_LE(std::abs(error), expected + tableError)
      << name << ' ' << body->thickness << ' ' << angle / Degree << ' ' << depth;
    EXPECT_LE(expected, 1.05 * made.error); // made.error was evaluated at the nodes only
    worst = std::max(worst, std::abs(error) - tableError > 0.0 ? expected / std::abs(error) : 0.0);
    ++rows;
  }
  EXPECT_GE(rows, 9);
  EXPECT_LT(worst, 4.0); // the estimate is an envelope over tools and depths, but not too large
}
} // namespace

// The table has an error of 0.5 %, the grid of the reference 0.1 %.
TEST(TiltLayer, AConesForceIsOffByNoMoreThanIsSaid)
{
  compare("cone60", 1.0, 25.0 * Degree, 6e-3);
}

TEST(TiltLayer, ABluntedConesForceIsOffByNoMoreThanIsSaid)
{
  compare("blunt45", 1.0, 25.0 * Degree, 6e-3);
}

// The wall of a flat end is also in contact: an error of 1.7 % up to 30°. The grid of the reference
// adds 0.35 %.
TEST(TiltLayer, AFlatsForceIsOffByNoMoreThanIsSaid)
{
  compare("flat", 0.5, 25.0 * Degree, 2.1e-2);
}

TEST(TiltLayer, NoErrorIsExpectedWhereTheProfileIsExact)
{
  EXPECT_EQ(tiltError({ 0.0, 2.0, 3.5 }), 0.03); // error of the table for a half-space
  EXPECT_EQ(tiltError({ 0.0, 1.0, 1.5 }), 0.02);
  EXPECT_EQ(tiltError({ 0.0, 1.0, 0.5 }), 0.006);
  EXPECT_EQ(tiltError({ 0.0, 1.2, 0.0 }), 0.005);
  EXPECT_EQ(tiltError({ 1.0, 1.0, 0.0 }), 0.0);
  // Errors in Data/Reference/tilt for a cone of 60° tilted by 10°: 0.1, 0.9 and 2.4 %.
  EXPECT_GE(tiltError({ 0.25, 1.159, 0.0 }), 0.001);
  EXPECT_GE(tiltError({ 0.5, 1.213, 0.0 }), 0.009);
  EXPECT_GE(tiltError({ 1.0, 1.247, 0.0 }), 0.024);
  EXPECT_LE(tiltError({ 1.0, 1.247, 0.0 }), 0.08);
}

TEST(TiltLayer, AThickLayerIsAHalfSpace)
{
  // C_g of a layer is M0/(πE*h): a/h = 1e-4 changes the force by 2e-4 and the factor by half of
  // this.
  const auto cone = tool("cone:60");
  const TiltBody thick{ 1e4, bonded(), 0.0 };
  const MadeTilt made = makeTiltTable(*cone, 1.0, 20.0 * Degree, { TiltBody(), thick });
  ASSERT_EQ(made.fault, "");
  const double first[] = { 1.0, 0.0 };
  const double second[] = { 0.0, 1.0 };
  const double onHalfSpace = made.table.at(0.4, 0.3, first).value;
  EXPECT_TRUE(agrees(made.table.at(0.4, 0.3, second).value, onHalfSpace, 3e-4));
  EXPECT_GT(onHalfSpace, 1.2);
}

TEST(TiltLayer, InSeriesTheLocalForceIsTheSame)
{
  // With a compliance in series F(D) is the local force at D - C F, for any tilt.
  const auto cone = tool("cone:60");
  const TiltBody soft{ 0.0, nullptr, 0.5 };
  const MadeTilt made = makeTiltTable(*cone, 2.0, 20.0 * Degree, { TiltBody(), soft });
  ASSERT_EQ(made.fault, "");
  const double second[] = { 0.0, 1.0 };
  const double first[] = { 1.0, 0.0 };
  for (const double depth : { 0.5, 1.3, 1.9 })
  {
    const double angle = 0.27;
    const TiltFactor tau = made.table.at(depth, angle, second);
    const TiltWork upright = pressedInto(*cone, soft, depth);
    const double force = upright.force * tau.value + upright.work * tau.byDepth;
    const double local = depth - soft.yielding * force;
    ASSERT_GT(local, 0.0);
    const TiltFactor alone = made.table.at(local, angle, first);
    const TiltWork below = pressedInto(*cone, {}, local);
    // Tables of 9 depths have an error of 3e-3; the slope in the series adds to it.
    EXPECT_TRUE(agrees(force, below.force * alone.value + below.work * alone.byDepth, 5e-3))
      << depth;
  }
}

TEST(TiltLayer, SaysHowDeepALayerAnswers)
{
  const auto cone = tool("cone:60");
  const MadeTilt made = makeTiltTable(*cone, 2.0, 20.0 * Degree, { { 0.1, bonded(), 0.0 } });
  EXPECT_NE(made.fault.find("a layer of 0.1 mm"), std::string::npos) << made.fault;
  EXPECT_NE(made.fault.find("not to the range of 2 mm"), std::string::npos) << made.fault;
}

TEST(TiltLayer, TheWorkIsTheIntegralOfTheForce)
{
  const auto truncated = tool("truncated:1,60");
  for (const TiltBody& body :
    { TiltBody(), TiltBody{ 2.0, bonded(), 0.0 }, TiltBody{ 2.0, bonded(), 0.3 } })
  {
    const double depth = 0.6;
    const double step = 1e-3;
    const double slope = (pressedInto(*truncated, body, depth + step).work -
                           pressedInto(*truncated, body, depth - step).work) /
      (2.0 * step);
    // Relative error of the difference: square of step / depth.
    EXPECT_TRUE(agrees(slope, pressedInto(*truncated, body, depth).force, 1e-5));
  }
}
} // namespace palpate::testing
