// SPDX-License-Identifier: BSD-3-Clause
// The body of the tick benchmark and of the exactness tests has the stated properties.
#include "BruteForce.h"
#include "BumpySphere.h"
#include "Sanitized.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <set>
#include <utility>

namespace palpate::testing
{
namespace
{
TEST(BumpySphere, IsClosedAndWoundOutward)
{
  const Surface body = bumpySphere(20);
  EXPECT_EQ(body.triangles.size(), 8U * 20 * 20);
  EXPECT_EQ(body.points.size(), 4U * 20 * 20 + 2);
  std::set<std::pair<std::int32_t, std::int32_t>> halfEdges;
  double volume = 0.0;
  for (std::size_t t = 0; t < body.triangles.size(); ++t)
  {
    const auto id = static_cast<std::int32_t>(t);
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(halfEdges.emplace(body.triangles[t][k], body.triangles[t][(k + 1) % 3]).second);
    }
    volume += body.corner(id, 0).cross(body.corner(id, 1)).dot(body.corner(id, 2)) / 6.0;
  }
  for (const auto& [from, to] : halfEdges)
  {
    EXPECT_EQ(halfEdges.count({ to, from }), 1U);
  }
  // 4/3 π r³ of the mean sphere, with an error of 0.4 % from the facets (edge, 12 mm, squared / 4
  // r²) and of at most 0.01 % from the mean square of the bumps.
  EXPECT_NEAR(volume / (4.0 / 3.0 * 3.14159265 * 1e6), 1.0, 0.01);
}

TEST(BumpySphere, NormalIsAcrossTheSurface)
{
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 u = windingDirection(7.0 * i);
    const Vector3 normal = bumpyNormal(u);
    const Vector3 side = u.unitOrthogonal();
    for (const Vector3& t : { side, Vector3(u.cross(side)) })
    {
      constexpr double h = 1e-5; // truncation h² 15³ = 3e-7 mm per 1e-3 mm, rounding 1e-14 / 1e-3
      const Vector3 moved =
        bumpyPoint((u + h * t).normalized()) - bumpyPoint((u - h * t).normalized());
      EXPECT_NEAR(normal.dot(moved) / moved.norm(), 0.0, 1e-6);
    }
    EXPECT_GT(normal.dot(u), 0.9);
  }
}

TEST(BumpySphere, IsNotConvexAndGentlerThanFiveMillimetres)
{
  // Bumps of 1 mm with 15 waves have curvatures of 1/100 + 15²/100² per mm at their top and 1/100 -
  // 15²/100² in a trough. Slopes and the radius of the bumps change these values by 3 %.
  const CurvatureRange range = bumpyCurvatures(100000);
  EXPECT_NEAR(range.greatest, 0.0325, 0.0010);
  EXPECT_NEAR(range.least, -0.0125, 0.0015);
  EXPECT_GT(1.0 / range.greatest, 5.0);
}

// The depth of a tip is its global distance from the surface, computed by brute force over all
// facets. A facet is inside the smooth body where the body is convex and outside where it is
// concave, by at most c²κ/2, with c = 2.4 mm (circumradius of an equilateral triangle of the
// longest edge, 4.2 mm) and κ = 0.033 / mm.
TEST(BumpySphere, TipsAreAsDeepAsTheySay)
{
  const Surface body = bumpySphere(60);
  const std::vector<std::int32_t> all = allTriangles(body);
  for (const double depth : { 1.0, 5.0 })
  {
    for (const Vector3& tip : windingTips(casesOf(40), depth, 47.0))
    {
      const auto distance = static_cast<double>(nearestOf(body, tip, all).distance);
      EXPECT_NEAR(distance, depth, 2.4 * 2.4 * 0.033 / 2.0);
    }
  }
}

TEST(BumpySphere, ShufflingChangesOnlyTheOrder)
{
  const Surface body = bumpySphere(10);
  std::vector<std::int32_t> pointOf;
  std::vector<std::int32_t> triangleOf;
  const Surface mixed = shuffled(body, 5, &pointOf, &triangleOf);
  ASSERT_EQ(mixed.triangles.size(), body.triangles.size());
  ASSERT_EQ(mixed.points.size(), body.points.size());
  std::size_t inPlace = 0;
  for (std::size_t t = 0; t < mixed.triangles.size(); ++t)
  {
    const auto id = static_cast<std::int32_t>(t);
    std::size_t first = 0;
    while (first < 3 && mixed.corner(id, 0) != body.corner(triangleOf[t], first))
    {
      ++first;
    }
    ASSERT_LT(first, 3U);
    for (std::size_t k = 1; k < 3; ++k)
    {
      EXPECT_EQ(mixed.corner(id, k), body.corner(triangleOf[t], (first + k) % 3));
    }
    inPlace += triangleOf[t] == id ? 1 : 0;
  }
  EXPECT_LT(inPlace, 20U); // of 800; the expected number is 1
}
} // namespace
} // namespace palpate::testing
