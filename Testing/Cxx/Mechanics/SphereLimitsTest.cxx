// SPDX-License-Identifier: BSD-3-Clause
// The exact sphere in its limits: Hertz's paraboloid for a << R, a cylinder with a wall for a → R.
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
    // a/R = √x (1 - x/6 + …), inserted in the closed form, gives F/F_Hertz = 1 - x/10 + O(x²). The
    // coefficient of x² is below 1; rounding adds 1e-15.
    EXPECT_NEAR(ratio, 1.0 - 0.1 * x, x * x + 1e-15) << x;
    const double radii = sphere.contactRadius(x * R) / paraboloid.contactRadius(x * R);
    EXPECT_NEAR(radii, 1.0 - x / 6.0, x * x + 1e-15) << x;
  }
}

TEST(SphereLimits, ForceIsSmoothWhereTheSeriesTakesOver)
{
  // The library changes its formula at a/R = 0.1. On both sides it is compared with the closed form
  // in long double. There (t²+1) artanh t - t multiplies the rounding of 1e-19 by 400; with the
  // root search the error is 2e-15.
  const double R = 2.0;
  const SphereTool sphere(R);
  for (const double t : { 0.05, 0.09, 0.0999999, 0.1000001, 0.11, 0.3 })
  {
    const long double w = std::atanh(static_cast<long double>(t));
    const auto depth = static_cast<double>(R * w * t);
    const auto expected =
      static_cast<double>(R * R * ((1.0L + t * static_cast<long double>(t)) * w - t));
    // Above t = 0.1 the closed form in double multiplies the rounding by up to t/(4/3 t³) = 75,
    // times a small factor.
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
    // 1 - a/R = 2 exp(-2δ/R) is below rounding, so a = R and F = E*(2Rδ - R²).
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
    // Near the rim p ∝ √(1-r²/a²): zero at the rim, and 1e-5 of the mean pressure next to it (times
    // 2.2 and more as a → R).
    EXPECT_NEAR(sphere.pressure(a, depth, 1.0), 0.0, 1e-6 * mean) << depth;
    EXPECT_NEAR(sphere.pressure(a * (1.0 - 1e-10), depth, 1.0), 0.0, 1e-4 * mean) << depth;
  }
}
