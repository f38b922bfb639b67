// SPDX-License-Identifier: BSD-3-Clause
// A negative compliance (a rigid base near the surface) folds the curve where 1 + C dF/dδ_local =
// 0. With k = |C| E* and the laws of the reference sheet, the fold is at
//   paraboloid  x = 1/(4k²R),         δ = x/3
//   cone        x = π/(4k tan α),     δ = x/2
//   flat        at every depth if 2ak >= 1, else nowhere.
#include "Mechanics/SeriesCompliance.h"

#include "Agreement.h"
#include "Quadrature.h"
#include "TestTools.h"

using palpate::Pi;
using palpate::seriesResponse;
using palpate::testing::agrees;
using palpate::testing::Rubber;
using palpate::testing::tool;

namespace
{
/// The smaller root x of x + C F(x) = δ below the fold, by bisection on the law itself.
template <class Law>
double bisect(double fold, double depth, Law&& total)
{
  long double low = 0.0L;
  long double high = fold;
  for (int i = 0; i < 200; ++i)
  {
    const long double middle = 0.5L * (low + high);
    (total(middle) < static_cast<long double>(depth) ? low : high) = middle;
  }
  return static_cast<double>(low);
}

/// Requires a solution at depths up to the fold, and none beyond the fold.
template <class Law>
void compare(
  const palpate::AxisymmetricTool& t, double compliance, double fold, double foldDepth, Law&& total)
{
  for (int i = 1; i <= 2000; ++i)
  {
    // Depth relative to that of the fold: evenly spaced, then approaching the fold.
    const double share = i <= 1000 ? i / 1001.0 : 1.0 - std::pow(10.0, -3.0 - (i - 1000) / 200.0);
    const double depth = share * foldDepth;
    const auto point = seriesResponse(t, Rubber, compliance, depth);
    ASSERT_TRUE(point.stable) << share;
    const double x = bisect(fold, depth, total);
    // Near the fold δ depends on x only to second order, so the rounding of δ is multiplied by
    // 1/√(1-share).
    EXPECT_TRUE(agrees(point.localDeflection, x, 1e-14 / std::sqrt(1.0 - share))) << share;
    EXPECT_GT(point.stiffness, t.stiffness(depth, Rubber));
  }
  for (const double share : { 1.0 + 1e-9, 1.001, 1.1, 2.0, 1e6 })
  {
    const auto point = seriesResponse(t, Rubber, compliance, share * foldDepth);
    EXPECT_FALSE(point.stable) << share;
    EXPECT_TRUE(std::isnan(point.force));
    EXPECT_TRUE(std::isnan(point.stiffness));
  }
}
} // namespace

TEST(SeriesFold, Paraboloid)
{
  for (const double compliance : { -0.001, -0.02, -0.5 })
  {
    const double k = -compliance * Rubber;
    const double R = 6.35;
    const double fold = 1.0 / (4.0 * k * k * R);
    compare(*tool("paraboloid:6.35"), compliance, fold, fold / 3.0,
      [&](long double x) { return x - 4.0L / 3.0L * k * std::sqrt(R * x) * x; });
  }
}

TEST(SeriesFold, Cone)
{
  for (const double compliance : { -0.001, -0.02, -0.5 })
  {
    const double k = -compliance * Rubber * std::tan(Pi / 3.0);
    const double fold = Pi / (4.0 * k);
    compare(*tool("cone:60"), compliance, fold, 0.5 * fold,
      [&](long double x) { return x - 2.0L * k * x * x / static_cast<long double>(Pi); });
  }
}

TEST(SeriesFold, Flat)
{
  const auto flat = tool("flat:1.6");
  const double critical = -1.0 / (2.0 * 1.6 * Rubber);
  for (const double depth : { 1e-6, 0.5, 100.0 })
  {
    const auto point = seriesResponse(*flat, Rubber, 0.9 * critical, depth);
    ASSERT_TRUE(point.stable);
    // F = 2aE*δ/(1 - 0.9): one division by a small difference.
    EXPECT_TRUE(agrees(point.force, 10.0 * flat->force(depth, Rubber), 1e-14));
    EXPECT_FALSE(seriesResponse(*flat, Rubber, 1.001 * critical, depth).stable);
  }
}
