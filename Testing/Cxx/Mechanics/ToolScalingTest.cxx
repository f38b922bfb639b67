// SPDX-License-Identifier: BSD-3-Clause
// A tool scaled by s: dimensional analysis gives F(δ; s) = s² F(δ/s) and a(δ; s) = s a(δ/s).
#include "Agreement.h"
#include "Quadrature.h"
#include "TestTools.h"

using palpate::Pi;
using palpate::scaledTool;
using palpate::testing::agrees;
using palpate::testing::tool;

TEST(ToolScaling, LengthsGrowByTheFactor)
{
  for (const char* name :
    { "flat:1.6", "paraboloid:6.35", "sphere:1.6", "truncated:1,60", "blunted:1,60",
      "rounded:1.2,0.4", "power:1.5,0.1", "power:4,0.01", "profile:0,0;1,0.25;2,1;4,4" })
  {
    const auto original = tool(name);
    for (const double factor : { 0.5, 1.0, 3.0 })
    {
      const auto scaled = scaledTool(*original, factor);
      ASSERT_NE(scaled, nullptr) << name;
      for (const double depth : { 0.01, 0.3, 1.0 })
      {
        // Near an edge the contact radius of a rounded flat end has a larger rounding error.
        EXPECT_TRUE(agrees(
          scaled->force(factor * depth, 2.0), factor * factor * original->force(depth, 2.0), 1e-13))
          << name;
        EXPECT_TRUE(agrees(
          scaled->contactRadius(factor * depth), factor * original->contactRadius(depth), 1e-13))
          << name;
      }
      EXPECT_TRUE(agrees(scaled->profile(factor), factor * original->profile(1.0), 1e-14) ||
        original->profile(1.0) == 0.0)
        << name;
    }
    EXPECT_EQ(scaledTool(*original, 1.0)->specification(), original->specification());
  }
}

TEST(ToolScaling, ConesHaveNoLengthButTheirTangent)
{
  const auto cone = scaledTool(*tool("cone:60"), 2.0);
  EXPECT_TRUE(agrees(cone->profile(1.0), 0.5 / std::sqrt(3.0), 1e-15));
  const auto power = scaledTool(*tool("power:1,0.5"), 2.0);
  EXPECT_TRUE(agrees(power->profile(1.0), 0.25, 1e-15));
  // F ∝ tan α.
  EXPECT_TRUE(agrees(cone->force(0.5, 1.0), 2.0 * tool("cone:60")->force(0.5, 1.0), 1e-14));
}

TEST(ToolScaling, RefusesFactorsThatAreNone)
{
  for (const double factor : { 0.0, -1.0, static_cast<double>(NAN), HUGE_VAL })
  {
    EXPECT_EQ(scaledTool(*tool("sphere:5"), factor), nullptr);
  }
  EXPECT_EQ(scaledTool(*tool("sphere:1e300"), 1e30), nullptr);
}
