// SPDX-License-Identifier: BSD-3-Clause
// The sag of a curved body in the law: a sphere on a sphere acts as one sphere, Hertz's ellipse, a
// flat end on a ball.
#include "Laws/LocalContact.h"
#include "Laws/ResponseLaw.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include "ReferenceTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

using namespace palpate;
using palpate::testing::ReferenceTable;

namespace
{
constexpr double Nodes = 1e-6; // error of cubic polynomials through 64 nodes

ContactSpot curved(double first, double second, double thickness = 0.0)
{
  return { 1.0, 0.45, 0.0, thickness, { first, second, 0.0 } };
}

double force(const ToolSpecification& tool, const ContactSpot& spot, double depth)
{
  const auto made = makeTool(tool);
  LocalContact contact(*made, 1.0, false, nullptr);
  if (spot.thickness > 0.0)
  {
    contact.prepareLayers({ LayerBase::Bonded, spot.thickness, spot.thickness, { 0.45 } });
  }
  bool fits = false;
  const double force = contact.law(spot, fits).at(depth).force;
  EXPECT_TRUE(fits);
  return force;
}
} // namespace

/// The profiles of two paraboloids add: 1/R + κ is the curvature of another paraboloid (Hertz
/// 1882).
TEST(CurvedContact, AParaboloidOnABallIsASharperOne)
{
  for (const double kappa : { -0.1, 0.05, 0.5 })
  {
    const double radius = 1.0 / (0.25 + kappa);
    for (const double depth : { 0.001, 0.3, 1.0 })
    {
      const double hertz = 4.0 / 3.0 * std::sqrt(radius) * std::pow(depth, 1.5);
      EXPECT_NEAR(
        force({ ToolShape::Paraboloid, 4.0 }, curved(kappa, kappa), depth) / hertz, 1.0, Nodes);
    }
  }
}

TEST(CurvedContact, OnALayerToo)
{
  const auto sharper = makeTool({ ToolShape::Paraboloid, 2.5 });
  const LayerContact exact(*sharper, std::make_shared<LayerKernel>(0.45, LayerBase::Bonded), 2.0);
  for (const double depth : { 0.05, 0.4, 1.0 })
  {
    // Sum of the error of two tables with 64 nodes each (1e-7) and that of the sag between its
    // nodes.
    EXPECT_NEAR(force({ ToolShape::Paraboloid, 4.0 }, curved(0.15, 0.15, 2.0), depth) /
        exact.evaluate(depth, 1.0).force,
      1.0, 1e-4);
  }
}

TEST(CurvedContact, UnequalCurvaturesAreHertzsEllipse)
{
  const ReferenceTable table("deep/curvature_hertz_ellipse.csv");
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double first = table.number(row, "R_kappa1");
    const double second = table.number(row, "R_kappa2");
    const double ratio = std::max((1.0 + first) / (1.0 + second), (1.0 + second) / (1.0 + first));
    if (ratio > 3.0 || std::min(first, second) <= -0.5)
    {
      continue;
    }
    const double found = force({ ToolShape::Paraboloid, 1.0 }, curved(first, second), 0.5);
    EXPECT_NEAR(found / std::pow(0.5, 1.5), table.number(row, "F/(Estar sqrtR delta^1.5)"), 3e-4)
      << first << " " << second;
  }
}

/// Until its rim touches the ball, a flat end acts as a plane on the ball; then F = 2 (aδ - a³κ/3).
TEST(CurvedContact, AFlatEndOnABall)
{
  constexpr double kappa = 0.1;
  constexpr double a = 2.0; // full contact at 0.4 mm
  const double ball = 4.0 / 3.0 * std::sqrt(1.0 / kappa) * std::pow(0.2, 1.5);
  EXPECT_NEAR(force({ ToolShape::Flat, a }, curved(kappa, kappa), 0.2) / ball, 1.0, 1e-4);
  for (const double depth : { 0.5, 1.0 })
  {
    const double whole = 2.0 * (a * depth - a * a * a * kappa / 3.0);
    EXPECT_NEAR(force({ ToolShape::Flat, a }, curved(kappa, kappa), depth) / whole, 1.0, 1e-4);
  }
}

/// In full contact, on saddles, on cylinders and in hollows, F = 2 (aδ - a³κ_m/3), with δ at the
/// middle of the flat end.
TEST(CurvedContact, AFlatEndInAHollowAndOnASaddle)
{
  constexpr double a = 2.0;
  for (const auto& [first, second] : { std::pair{ -0.1, -0.1 }, std::pair{ -0.05, 0.1 },
         std::pair{ -0.1, 0.02 }, std::pair{ 0.0, 0.1 } })
  {
    const double mean = 0.5 * (first + second);
    const SpotCurvature shape{ first, second, 0.0 };
    EXPECT_NEAR(wholeFrom(a, shape), 0.1 * a * a, 1e-12);
    for (const double depth : { 0.5, 1.0 })
    {
      const double whole = 2.0 * (a * depth - a * a * a * mean / 3.0);
      EXPECT_NEAR(force({ ToolShape::Flat, a }, curved(first, second), depth) / whole, 1.0, 1e-4);
    }
    // Before full contact the force rises from zero continuously.
    const double early = force({ ToolShape::Flat, a }, curved(first, second), 0.1);
    EXPECT_GT(early, 0.0);
    EXPECT_LT(early, force({ ToolShape::Flat, a }, curved(first, second), 0.3));
  }
}

/// ΔF = -(2/3) a³ κ_m to first order, for any tool.
TEST(CurvedContact, TheFirstOrderIsThatOfAnyTool)
{
  constexpr double kappa = 1e-4;
  for (const ToolSpecification& given : { ToolSpecification{ ToolShape::Sphere, 3.0 },
         ToolSpecification{ ToolShape::Cone, 0.0, 70.0 } })
  {
    const auto made = makeTool(given);
    const double a = made->contactRadius(0.8);
    const double change =
      force(given, curved(1.5 * kappa, 0.5 * kappa), 0.8) - made->force(0.8, 1.0);
    // The second-order part is κ a²/δ = 2e-4 of the change. The error of the nodes is 1e-6 of F,
    // which is 1e-2 of the change.
    EXPECT_NEAR(change, -2.0 / 3.0 * a * a * a * kappa, 0.02 * std::abs(change));
  }
}

TEST(CurvedContact, AToolThatDoesNotFitIsOnAFlatBody)
{
  const auto made = makeTool({ ToolShape::Sphere, 10.0 });
  const LocalContact contact(*made, 1.0, false, nullptr);
  const ContactSpot hollow = curved(-0.2, -0.2);
  bool fits = true;
  EXPECT_NEAR(contact.law(hollow, fits).at(0.5).force / made->force(0.5, 1.0), 1.0, Nodes);
  EXPECT_FALSE(fits);
}

/// Compares with finite elements of a ball. The law adds the profiles of tool and ball; the
/// remaining difference is the structural compliance of the ball.
TEST(CurvedContact, OnABallTheRestIsStructural)
{
  const ReferenceTable table("deep/curvature_sphere_on_ball.csv");
  int rows = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double ball = table.number(row, "Rb_over_R(negative: cavity)");
    const double depth = table.number(row, "delta_over_R");
    if (table.number(row, "nu") != 0.45 || ball < 2.0 || depth > 1.0)
    {
      continue;
    }
    const auto made = makeTool({ ToolShape::Sphere, 1.0 });
    const LocalContact contact(*made, 1.0, false, nullptr);
    const ContactSpot spot = curved(1.0 / ball, 1.0 / ball);
    const LocalState state = contact.law(spot).at(depth);
    const double found = state.force / (1.0 - 0.45 * 0.45);
    const double error = std::abs(found / table.number(row, "F_fe_over_E") - 1.0);
    EXPECT_LE(error, 0.46 * state.radius / ball + 0.01) << "ball " << ball << ", depth " << depth;
    ++rows;
  }
  EXPECT_GT(rows, 5);
}

TEST(ResponseLaw, TakesTheSpotsCurvature)
{
  const auto made = makeTool({ ToolShape::Paraboloid, 4.0 });
  ResponseLaw law(*made, 1.0, 8);
  law.correct(std::make_shared<LocalContact>(*made, 1.0, false, nullptr));
  std::vector<float> forces(8);
  std::vector<float> stiffnesses(8);
  ContactSpot spot = curved(0.25, 0.25);
  ASSERT_EQ(law.sample(spot, forces.data(), stiffnesses.data()), ResponseStatus::Valid);
  const double hertz = 4.0 / 3.0 * std::sqrt(2.0);
  EXPECT_NEAR(static_cast<double>(forces[7]) / hertz, 1.0, Nodes);
  EXPECT_NEAR(static_cast<double>(stiffnesses[7]) / (1.5 * hertz), 1.0, 1e-5);

  // With a compliance in series: δ = δ_local + C F.
  spot.compliance = 0.3;
  const IndentationPoint felt = law.evaluate(spot, 1.0);
  const double local = 1.0 - 0.3 * felt.force;
  EXPECT_NEAR(felt.force / (4.0 / 3.0 * std::sqrt(2.0) * std::pow(local, 1.5)), 1.0, Nodes);
}
