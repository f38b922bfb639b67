// SPDX-License-Identifier: BSD-3-Clause
// The outline of a tool against its profile, and the distance from the outline against a search
// along it.
#include "Mechanics/FiniteStrain/ToolOutline.h"

#include "Agreement.h"
#include "Quadrature.h"
#include "TestTools.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>

using Eigen::Vector2d;
using palpate::Pi;
using palpate::ToolOutline;
using palpate::testing::tool;

namespace
{
const char* const All[] = { "flat:1", "sphere:2", "paraboloid:2", "cone:60", "truncated:1,45",
  "blunted:0.5,50", "rounded:1,0.5", "power:1.5,0.3", "power:4,0.3",
  "profile:0,0;0.3,0.02;0.6,0.09;0.9,0.21;1.2,0.4" };
constexpr double Reach = 1.1;
constexpr double Fillet = 0.05;
} // namespace

TEST(ToolOutline, FollowsTheProfileBesideItsFillets)
{
  for (const char* name : All)
  {
    const auto given = tool(name);
    const ToolOutline outline(*given, Reach, Fillet);
    for (double r = 0.01; r < std::min(Reach, given->largestContactRadius()) - 2.0 * Fillet;
         r += 0.013)
    {
      const bool isAtFillet = std::any_of(outline.fillets().begin(), outline.fillets().end(),
        [r](const auto& range) { return r > range.first - 1e-9 && r < range.second + 1e-9; });
      // Error of biarcs through 24 points of the profile. Next to the apex of a power law the
      // curvature is unbounded.
      if (!isAtFillet)
      {
        EXPECT_NEAR(outline.height(r), given->profile(r), 2e-5) << name << " at " << r;
      }
    }
  }
}

TEST(ToolOutline, DistanceIsTheShortestWayAndItsGradientPointsAlongIt)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(0.0, Reach);
  for (const char* name : All)
  {
    const ToolOutline outline(*tool(name), 3.0, Fillet);
    for (int i = 0; i < 60; ++i)
    {
      const Vector2d point(anywhere(random), outline.height(0.0) - 0.3 * anywhere(random));
      const ToolOutline::Distance found = outline.distance(point);
      // smallest distance of a point below the tool, by a search along the outline
      double least = HUGE_VAL;
      for (double r = 0.0; r < 2.5; r += 1e-3)
      {
        const double z = outline.height(r);
        least = std::isfinite(z) ? std::min(least, (Vector2d(r, z) - point).norm()) : least;
      }
      // The nearest sampled point is up to half a step away from the foot, on a slope below 7.
      EXPECT_LE(found.value, least + 1e-9) << name << " at " << point.transpose();
      EXPECT_GE(found.value, least - 1e-5 / std::max(found.value, 1e-3))
        << name << " at " << point.transpose();
      EXPECT_NEAR(found.gradient.norm(), 1.0, 1e-12);
      // At the foot the distance is zero.
      EXPECT_NEAR(outline.distance(point - found.value * found.gradient).value, 0.0, 1e-7) << name;
      constexpr double step = 1e-6;
      for (int c = 0; c < 2; ++c)
      {
        const Vector2d by = step * Vector2d::Unit(c);
        const Vector2d bend =
          (outline.distance(point + by).gradient - outline.distance(point - by).gradient) /
          (2.0 * step);
        // The curvature jumps where the foot moves from one arc to the next. These points are
        // skipped.
        if ((bend - found.hessian.col(c)).norm() > 1e-4)
        {
          const Vector2d half = (outline.distance(point + by).gradient - found.gradient) / step;
          const Vector2d other = (found.gradient - outline.distance(point - by).gradient) / step;
          EXPECT_GT((half - other).norm(), 1e-5) << name << " at " << point.transpose();
        }
      }
    }
  }
}

TEST(ToolOutline, AnApexIsASphereThatTouchesTheFlank)
{
  const ToolOutline outline(*tool("cone:60"), Reach, Fillet);
  // A sphere of radius ρ in a cone of half angle α: the lowest point of the sphere is ρ(1/sin α -
  // 1) above the apex.
  EXPECT_NEAR(outline.height(0.0), Fillet * (1.0 / std::sin(Pi / 3.0) - 1.0), 1e-9);
  ASSERT_EQ(outline.fillets().size(), 1U);
  EXPECT_NEAR(outline.fillets()[0].second, Fillet * std::cos(Pi / 3.0), 1e-9);
  EXPECT_NEAR(outline.distance({ 0.0, 0.0 }).hessian.trace() *
      (Fillet + outline.distance({ 0.0, 0.0 }).value),
    1.0, 1e-6);
}

TEST(ToolOutline, ARimIsAQuarterOfACircle)
{
  const ToolOutline outline(*tool("flat:1"), Reach, Fillet);
  for (double angle = 0.05; angle < 1.5; angle += 0.1)
  {
    const Vector2d out(std::sin(angle), -std::cos(angle));
    const Vector2d centre(1.0 - Fillet, Fillet);
    EXPECT_NEAR(outline.distance(centre + 0.3 * out).value, 0.3 - Fillet, 1e-9);
  }
  EXPECT_NEAR(outline.distance({ 1.2, 0.5 }).value, 0.2, 1e-9); // distance from the wall
  EXPECT_LT(outline.distance({ 0.5, 0.02 }).value, 0.0);
}
