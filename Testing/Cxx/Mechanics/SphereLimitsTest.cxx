// SPDX-License-Identifier: BSD-3-Clause
// The exact sphere between its limits: Hertz's paraboloid at a << R, a wall at a → R.
#include "Mechanics/Tools/ParaboloidTool.h"
#include "Mechanics/Tools/SphereTool.h"

#include "Agreement.h"

using palpate::ParaboloidTool;
using palpate::SphereTool;
using palpate::testing::agrees;

TEST(SphereLimits, IsHertzsParaboloidAtSmallDepth)
{
  const double R = 6.35;
  const SphereTool sphere(R);
  const ParaboloidTool paraboloid(R);
  for (const double x : { 1e-2, 1e-3, 1e-4, 1e-6, 1e-9, 1e-14 })
  {
    const double ratio = sphere.force(x * R, 1.0) / paraboloid.force(x * R, 1.0);
    // a/R = √x (1 - x/6 + …) inserted in the closed form: F/F_Hertz = 1 - x/10 + O(x²), with a
    // coefficient of x² below 1; 1e-15 for rounding.
    EXPECT_NEAR(ratio, 1.0 - 0.1 * x, x * x + 1e-15) << x;
    const double radii = sphere.contactRadius(x * R) / paraboloid.contactRadius(x * R);
    EXPECT_NEAR(radii, 1.0 - x / 6.0, x * x + 1e-15) << x;
  }
}

TEST(SphereLimits, ForceIsSmoothWhereTheSeriesTakesOver)
{
  // The library switches formulas at a/R = 0.1. On both sides it is compared with the closed form
  // in long double: (t²+1) artanh t - t loses 400 of its 1e-19, 2e-15 with the root search.
  const double R = 2.0;
  const SphereTool sphere(R);
  for (const double t : { 0.05, 0.09, 0.0999999, 0.1000001, 0.11, 0.3 })
  {
    const long double w = std::atanh(static_cast<long double>(t));
    const auto depth = static_cast<double>(R * w * t);
    const auto expected =
      static_cast<double>(R * R * ((1.0L + t * static_cast<long double>(t)) * w - t));
    // The closed form in double above t = 0.1 loses up to t/(4/3 t³) = 75 roundings, times a small
    // factor.
    EXPECT_TRUE(agrees(sphere.force(depth, 1.0), expected, 5e-14)) << t;
    EXPECT_TRUE(agrees(sphere.contactRadius(depth), R * t, 1e-15)) << t;
  }
}

TEST(SphereLimits, ContactRadiusStaysBelowTheRadius)
{
  const double R = 1.6;
  const SphereTool sphere(R);
  double previous = 0.0;
  for (const double depths : { 0.1, 1.0, 3.0, 8.0, 15.0 })
  {
    const double a = sphere.contactRadius(depths * R);
    EXPECT_GT(a, previous);
    EXPECT_LT(a, R) << depths;
    previous = a;
  }
}

TEST(SphereLimits, AbsurdDepthsActLikeAFlatEndedPunch)
{
  const double R = 1.6;
  const SphereTool sphere(R);
  for (const double depths : { 20.0, 1e3, 1e9, 1e100 })
  {
    const double depth = depths * R;
    // 1 - a/R = 2 exp(-2δ/R) is below rounding: a = R, and F = E*(2Rδ - R²).
    EXPECT_LE(sphere.contactRadius(depth), R);
    EXPECT_TRUE(agrees(sphere.contactRadius(depth), R, 1e-15));
    EXPECT_TRUE(agrees(sphere.force(depth, 1.0), 2.0 * R * depth - R * R, 1e-14)) << depths;
  }
}

TEST(SphereLimits, PressureVanishesAtTheRim)
{
  const SphereTool sphere(1.6);
  for (int i = 1; i <= 400; ++i)
  {
    const double depth = 0.005 * i;
    const double a = sphere.contactRadius(depth);
    const double mean = sphere.force(depth, 1.0) / (3.14159265358979 * a * a);
    // p ∝ √(1-r²/a²) near the rim: 0 at the rim, 1e-5 of the mean next to it (times 2.2 and more as
    // a → R).
    EXPECT_NEAR(sphere.pressure(a, depth, 1.0), 0.0, 1e-6 * mean) << depth;
    EXPECT_NEAR(sphere.pressure(a * (1.0 - 1e-10), depth, 1.0), 0.0, 1e-4 * mean) << depth;
  }
}
