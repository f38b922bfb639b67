// SPDX-License-Identifier: BSD-3-Clause
// A tool on a curved half-space at given depths: closed forms of paraboloids, cones and flat ends,
// with a compliance in series, in hollows.
#include "Laws/CurvedHalfSpace.h"
#include "Laws/LocalContact.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

using namespace palpate;

namespace
{
constexpr double Deepest = 2.1;
const std::vector<double> Depths = { 1e-5, 0.01, 0.1, 0.4, 1.0 };

std::vector<LocalState> solved(
  const ToolSpecification& tool, const SpotCurvature& curvature, double softness = 0.0)
{
  std::vector<LocalState> states(Depths.size());
  const auto made = makeTool(tool);
  const CurvedHalfSpace contact(*made, Deepest);
  EXPECT_TRUE(contact.solve(curvature, softness, Depths, states.data()));
  return states;
}
} // namespace

/// 1/R + κ is the curvature of another paraboloid (Hertz 1882). Its interpolated function is a
/// power law.
TEST(CurvedHalfSpace, AParaboloidOnABallIsASharperOne)
{
  for (const double kappa : { -0.12, 0.0, 0.05, 5.0 })
  {
    const double radius = 1.0 / (0.25 + kappa);
    const auto states = solved({ ToolShape::Paraboloid, 4.0 }, { kappa, kappa, 0.0 });
    for (std::size_t i = 0; i < Depths.size(); ++i)
    {
      const double d = Depths[i];
      EXPECT_NEAR(states[i].radius / std::sqrt(radius * d), 1.0, 1e-9);
      EXPECT_NEAR(states[i].force / (4.0 / 3.0 * std::sqrt(radius) * std::pow(d, 1.5)), 1.0, 1e-9);
      EXPECT_NEAR(states[i].stiffness / (2.0 * states[i].radius), 1.0, 1e-12);
      EXPECT_NEAR(states[i].depth, d, 1e-9 * d);
    }
  }
}

/// Depths between the nodes of the table of the exact sphere, and in the first interval of the
/// table, where the contact radius is taken as a power of √δ.
TEST(CurvedHalfSpace, OnAFlatBodyTheToolIsAlone)
{
  for (const ToolSpecification& tool :
    { ToolSpecification{ ToolShape::Sphere, 2.5 }, ToolSpecification{ ToolShape::Flat, 1.6 } })
  {
    const auto made = makeTool(tool);
    const auto states = solved(tool, {});
    for (std::size_t i = 0; i < Depths.size(); ++i)
    {
      const IndentationPoint exact = made->evaluate(Depths[i], 1.0);
      const double within = i == 0 ? 1e-4 : 1e-7;
      EXPECT_NEAR(states[i].force / exact.force, 1.0, within);
      EXPECT_NEAR(states[i].radius / exact.contactRadius, 1.0, within);
    }
  }
}

/// A cone with g = (π/2) c a on a ball with the sag κ a²: at a given radius their depths and their
/// forces add up.
TEST(CurvedHalfSpace, AConeOnABall)
{
  const ToolSpecification cone{ ToolShape::Cone, 0.0, 60.0 };
  const double c = 1.0 / std::tan(Pi / 3.0);
  constexpr double kappa = 0.05;
  const auto states = solved(cone, { kappa, kappa, 0.0 });
  for (std::size_t i = 0; i < Depths.size(); ++i)
  {
    const double p = 0.5 * Pi * c;
    const double a = (std::sqrt(p * p + 4.0 * kappa * Depths[i]) - p) / (2.0 * kappa);
    EXPECT_NEAR(states[i].radius / a, 1.0, 1e-7);
    EXPECT_NEAR(
      states[i].force / (0.5 * Pi * c * a * a + 4.0 / 3.0 * kappa * a * a * a), 1.0, 1e-7);
  }
}

/// A flat end is in full contact from the depth a²κ on, with F = 2(aδ - a³κ/3). At smaller depths
/// the contact is that of a plane on a ball.
TEST(CurvedHalfSpace, AFlatEndOnABall)
{
  constexpr double a = 1.6;
  constexpr double kappa = 0.05; // full contact at 0.128 mm
  const auto states = solved({ ToolShape::Flat, a }, { kappa, kappa, 0.0 });
  for (std::size_t i = 0; i < Depths.size(); ++i)
  {
    const double d = Depths[i];
    const double force = d < a * a * kappa ? 4.0 / 3.0 * std::sqrt(1.0 / kappa) * std::pow(d, 1.5)
                                           : 2.0 * (a * d - a * a * a * kappa / 3.0);
    EXPECT_NEAR(states[i].force / force, 1.0, 1e-9);
    EXPECT_TRUE(states[i].isCovered);
  }
}

/// A flat end touches a hollow first with its rim. No law covers the depths before full contact;
/// then the mean of the sag counts, as for any circle in full contact.
TEST(CurvedHalfSpace, AFlatEndInAHollow)
{
  constexpr double a = 1.6;
  const SpotCurvature saddle{ -0.03, 0.01, 0.0 };
  const auto states = solved({ ToolShape::Flat, a }, saddle);
  EXPECT_FALSE(states[1].isCovered);
  EXPECT_TRUE(states[3].isCovered);
  EXPECT_NEAR(states[4].force / (2.0 * (a - a * a * a * saddle.mean() / 3.0)), 1.0, 2e-3);
  for (std::size_t i = 1; i < Depths.size(); ++i)
  {
    EXPECT_GT(states[i].force, states[i - 1].force);
  }
}

/// δ = δ_local + C F: the force is that of the local part of the depth.
TEST(CurvedHalfSpace, InSeries)
{
  constexpr double softness = 0.3;
  for (const ToolShape shape : { ToolShape::Paraboloid, ToolShape::Flat })
  {
    const auto states = solved({ shape, 1.6 }, { 0.1, 0.1, 0.0 }, softness);
    for (std::size_t i = 0; i < Depths.size(); ++i)
    {
      EXPECT_NEAR(states[i].depth + softness * states[i].force, Depths[i], 1e-8 * Depths[i]);
    }
  }
  const auto one = solved({ ToolShape::Paraboloid, 4.0 }, { 0.1, 0.1, 0.0 }, softness);
  const double local = one[4].depth;
  EXPECT_NEAR(one[4].force / (4.0 / 3.0 / std::sqrt(0.35) * std::pow(local, 1.5)), 1.0, 1e-9);
}

/// On a soft body the local depth is a small part of the deflection. Here it is smaller than the
/// depth at which a flat end reaches full contact with a bump: δ = d + C E* F(d) (Hertz 1882).
TEST(CurvedHalfSpace, AFlatEndOnABumpOfASoftBody)
{
  const SpotCurvature bump{ 0.05, 0.02, 0.0 };
  for (const double softness : { 0.3, 10.0, 1e3, 1e5 })
  {
    const auto states = solved({ ToolShape::Flat, 1.6 }, bump, softness);
    for (std::size_t i = 0; i < Depths.size(); ++i)
    {
      ASSERT_GT(states[i].depth, 0.0) << "softness " << softness << ", " << Depths[i] << " mm";
      // The last step starts within 1e-5 of the deflection, and its error is squared.
      EXPECT_NEAR(states[i].depth + softness * states[i].force, Depths[i], 1e-6 * Depths[i])
        << "softness " << softness;
    }
  }
}

TEST(CurvedHalfSpace, ANarrowHollowIsSaid)
{
  const auto tool = makeTool({ ToolShape::Paraboloid, 4.0 });
  const CurvedHalfSpace contact(*tool, Deepest);
  std::vector<LocalState> states(Depths.size());
  EXPECT_TRUE(contact.solve({ -0.12, 0.0, 0.0 }, 0.0, Depths, states.data()));
  EXPECT_FALSE(contact.solve({ -0.13, 0.0, 0.0 }, 0.0, Depths, states.data()));
  EXPECT_FALSE(contact.solve({ -3.0, -3.0, 0.0 }, 0.0, Depths, states.data()));
}

/// At finite strain the force from nodes (error 1e-6; 1e-3 for the stiffness, from differences)
/// agrees with the force computed at each depth.
TEST(CurvedHalfSpace, FiniteStrainAsInNodes)
{
  const auto tool = makeTool({ ToolShape::Sphere, 4.0 });
  std::unique_ptr<StrainCorrection> strain;
  ASSERT_EQ(makeStrainCorrection(
              *tool, { StrainModel::NeoHooke, 0.0 }, { 0.3, 0.3, true }, 1.0, {}, strain),
    "");
  const LocalContact contact(*tool, 1.0, false, strain.get());
  const ContactSpot spot{ 1.0, 0.3, 0.0, 0.0, { 0.03, 0.06, 0.0 } };
  ASSERT_TRUE(contact.isDirect(spot));
  std::vector<LocalState> states(Depths.size());
  EXPECT_TRUE(contact.states(spot, Depths, states.data()));
  const NodeLaw nodes = contact.law(spot);
  for (std::size_t i = 2; i < Depths.size(); ++i)
  {
    EXPECT_NEAR(states[i].force / nodes.at(Depths[i]).force, 1.0, 1e-5);
    EXPECT_NEAR(states[i].stiffness / nodes.at(Depths[i]).stiffness, 1.0, 2e-3);
  }
}
