// SPDX-License-Identifier: BSD-3-Clause
// How local a contact is and what the tool's size does, where both are known by heart.
#include "Laws/RegimeLaw.h"

#include "Paraboloid.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace palpate;
using palpate::testing::Paraboloid;

namespace
{
constexpr double Deepest = 2.0;  // mm
constexpr double Central = 1e-4; // the difference over ±1 % of the size errs by 2e-5
} // namespace

TEST(RegimeLaw, AHalfSpaceIsLocal)
{
  const Paraboloid paraboloid;
  const auto tool = paraboloid.make();
  const RegimeLaw law(*tool, MaterialRange(LayerBase::Bonded), Deepest);
  ASSERT_TRUE(law.complete());
  const ContactSpot spot{ 0.06, 0.45, 0.0, 0.0 };
  const double force = law.force(spot, 1.0);
  EXPECT_NEAR(force, paraboloid.force(1.0, 0.06), 1e-12);
  const SpotRegime found = law.regime(spot, 1.0, force);
  EXPECT_NEAR(found.index, 0.0, 1e-9);
  EXPECT_NEAR(found.sensitivity, 0.5, Central); // F ∝ √R
  EXPECT_EQ(found.verdict, RegimeVerdict::ShapeMatters);
}

TEST(RegimeLaw, AFlatIsAsStiffAsItIsWide)
{
  const auto tool = makeTool({ ToolShape::Flat, 3.0 });
  const RegimeLaw law(*tool, MaterialRange(LayerBase::Bonded), Deepest);
  const ContactSpot spot{ 0.06, 0.45, 0.0, 0.0 };
  EXPECT_NEAR(law.regime(spot, 1.0, law.force(spot, 1.0)).sensitivity, 1.0, Central);
}

TEST(RegimeLaw, ASoftBodyTakesTheDepthUponItself)
{
  const auto tool = Paraboloid{}.make();
  const RegimeLaw law(*tool, MaterialRange(LayerBase::Bonded), Deepest);
  const double compliance = 400.0; // mm/N: a long strip
  const ContactSpot spot{ 0.06, 0.45, compliance, 0.0 };
  const double force = law.force(spot, 1.0);
  const SpotRegime found = law.regime(spot, 1.0, force);
  EXPECT_NEAR(found.index, compliance * force, 1e-9); // C F/δ
  // dlnF/dlnR of the series: ½/(1 + 1.5 C F/δ_local).
  const double local = 1.0 - compliance * force;
  EXPECT_NEAR(found.sensitivity, 0.5 / (1.0 + 1.5 * compliance * force / local), Central);
  EXPECT_EQ(found.verdict, RegimeVerdict::PointForceSuffices);
}

TEST(RegimeLaw, WithoutAStableContactItIsNotKnown)
{
  const auto tool = Paraboloid{}.make();
  const RegimeLaw law(*tool, MaterialRange(LayerBase::Bonded), Deepest);
  const ContactSpot spot{ 0.06, 0.45, -20.0, 0.0 };
  const SpotRegime found = law.regime(spot, 2.0, law.force(spot, 2.0));
  EXPECT_TRUE(std::isnan(found.index));
  EXPECT_EQ(found.verdict, RegimeVerdict::ShapeMatters);
}

TEST(RegimeLaw, OnALayerTheShapeMattersMore)
{
  const auto tool = Paraboloid{}.make();
  MaterialRange range(LayerBase::Bonded);
  const ContactSpot spot{ 0.06, 0.45, 0.0, 2.0 };
  range.add(spot);
  const RegimeLaw law(*tool, range, Deepest);
  const SpotRegime found = law.regime(spot, 1.0, law.force(spot, 1.0));
  EXPECT_LT(found.index, 0.0); // stiffened by the base
  EXPECT_GT(found.sensitivity, 0.5);
}
