// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/TriangleProjection.h"

#include "BruteForce.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>

using palpate::PlaneFoot;
using palpate::projectOnFace;
using palpate::projectOnTriangle;
using palpate::TriangleFeature;
using palpate::TriangleProjection;
using palpate::Vector3;
using palpate::testing::Nearest;
using palpate::testing::nearestOfTriangle;

namespace
{
Vector3 randomPoint(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> coordinate(-size, size);
  const double x = coordinate(random);
  const double y = coordinate(random);
  return { x, y, coordinate(random) };
}

double areaOf(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return 0.5 * (b - a).cross(c - a).norm();
}

/// Expects that the weights are area coordinates: >= 0, with the sum 1, and that they give the
/// point.
void expectWeights(
  const TriangleProjection& found, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double size = std::max({ a.norm(), b.norm(), c.norm() });
  EXPECT_GE(found.weights.minCoeff(), 0.0);
  EXPECT_NEAR(found.weights.sum(), 1.0, 4e-16); // rounding of two additions
  const Vector3 point = found.weights[0] * a + found.weights[1] * b + found.weights[2] * c;
  EXPECT_LE((point - found.point).norm(), 4e-15 * size); // a few roundings of the coordinates
}
} // namespace

TEST(TriangleProjection, BruteForceOnRandomTriangles)
{
  std::mt19937 random(1);
  std::array<int, 7> features{};
  for (int i = 0; i < 20000; ++i)
  {
    const Vector3 a = randomPoint(random, 1.0);
    const Vector3 b = randomPoint(random, 1.0);
    const Vector3 c = randomPoint(random, 1.0);
    const Vector3 tip = randomPoint(random, i % 2 == 0 ? 1.0 : 5.0);
    const double longest = std::max({ (b - a).norm(), (c - b).norm(), (a - c).norm() });
    const double height = 2.0 * areaOf(a, b, c) / longest;
    if (height < 1e-2 * longest)
    {
      continue; // slivers have a separate test
    }
    const TriangleProjection found = projectOnTriangle(tip, a, b, c);
    const Nearest nearest = nearestOfTriangle(tip, a, b, c);
    ++features[static_cast<std::size_t>(found.feature)];
    expectWeights(found, a, b, c);
    // Rounding at 1e-16 of the tip's distance, multiplied by longest side / height <= 100.
    EXPECT_LE((found.point.cast<long double>() - nearest.point).norm(), 2e-13L);
    EXPECT_NEAR(std::sqrt(found.squaredDistance), static_cast<double>(nearest.distance), 2e-14);
  }
  for (const int count : features)
  {
    EXPECT_GT(count, 500); // each feature occurs
  }
}

TEST(TriangleProjection, WeightsAreAreas)
{
  std::mt19937 random(2);
  int onFace = 0;
  for (int i = 0; i < 5000; ++i)
  {
    const Vector3 a = randomPoint(random, 1.0);
    const Vector3 b = randomPoint(random, 1.0);
    const Vector3 c = randomPoint(random, 1.0);
    const double area = areaOf(a, b, c);
    const TriangleProjection found = projectOnTriangle(randomPoint(random, 1.0), a, b, c);
    if (found.feature != TriangleFeature::Face || area < 0.1)
    {
      continue;
    }
    ++onFace;
    // Equation 4 of Mahvash and Hayward: the area opposite a corner divided by the whole area.
    EXPECT_NEAR(found.weights[0], areaOf(found.point, b, c) / area, 1e-14);
    EXPECT_NEAR(found.weights[1], areaOf(found.point, c, a) / area, 1e-14);
    EXPECT_NEAR(found.weights[2], areaOf(found.point, a, b) / area, 1e-14);
  }
  EXPECT_GT(onFace, 500);
}

TEST(TriangleProjection, OnTheTriangleItself)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 a = randomPoint(random, 1.0);
    const Vector3 b = randomPoint(random, 1.0);
    const Vector3 c = randomPoint(random, 1.0);
    const double v = share(random);
    const double w = (1.0 - v) * share(random);
    const Vector3 tip = a + v * (b - a) + w * (c - a);
    // The foot of a point in the plane moves by the rounding of the areas: 1e-16/sin² of an angle.
    const double sine = (b - a).normalized().cross((c - a).normalized()).norm();
    EXPECT_LE(std::sqrt(projectOnTriangle(tip, a, b, c).squaredDistance), 4e-15 / (sine * sine));
    for (const Vector3& corner : { a, b, c })
    {
      const TriangleProjection at = projectOnTriangle(corner, a, b, c);
      EXPECT_LE((at.point - corner).norm(), 1e-15); // a + (b - a) is rounded
      EXPECT_LT(static_cast<int>(at.feature), 3);
    }
  }
}

TEST(TriangleProjection, NamesTheFeature)
{
  const Vector3 a(0, 0, 0);
  const Vector3 b(4, 0, 0);
  const Vector3 c(0, 4, 0);
  const std::pair<Vector3, TriangleFeature> cases[] = {
    { { -1, -1, 1 }, TriangleFeature::Corner0 },
    { { 6, -1, 1 }, TriangleFeature::Corner1 },
    { { -1, 6, 1 }, TriangleFeature::Corner2 },
    { { 2, -1, 1 }, TriangleFeature::Edge0 },
    { { 4, 4, 1 }, TriangleFeature::Edge1 },
    { { -1, 2, 1 }, TriangleFeature::Edge2 },
    { { 1, 1, 1 }, TriangleFeature::Face },
  };
  for (const auto& [tip, feature] : cases)
  {
    EXPECT_EQ(projectOnTriangle(tip, a, b, c).feature, feature) << tip.transpose();
  }
}

TEST(TriangleProjection, Slivers)
{
  // Triangles with one short side or one wide angle whose height is `thin` times their length, with
  // any order of corners, and tips near and far.
  std::mt19937 random(4);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const double thin : { 1e-3, 1e-5, 1e-7, 1e-8, 1e-9, 1e-11, 1e-13 })
  {
    double worst = 0.0;
    for (int i = 0; i < 6000; ++i)
    {
      const Vector3 along = randomPoint(random, 1.0).normalized();
      const Vector3 across = along.cross(randomPoint(random, 1.0)).normalized();
      std::array<Vector3, 3> corner;
      corner[0] = randomPoint(random, 1.0);
      corner[1] = corner[0] + along;
      corner[2] = corner[0] + (i % 3 == 0 ? 0.0 : share(random)) * along + thin * across;
      const Vector3 tip =
        corner[0] + share(random) * along + randomPoint(random, i % 2 == 0 ? 1e-3 : 0.5);
      std::shuffle(corner.begin(), corner.end(), random);
      const auto& [a, b, c] = corner;
      if ((b - a).cross(c - a).norm() < 0.5 * thin)
      {
        continue;
      }
      const TriangleProjection found = projectOnTriangle(tip, a, b, c);
      const Nearest nearest = nearestOfTriangle(tip, a, b, c);
      expectWeights(found, a, b, c);
      worst = std::max(
        worst, std::abs(std::sqrt(found.squaredDistance) - static_cast<double>(nearest.distance)));
    }
    // A sliver of height h is a segment to within h. For larger h, rounding of cross products moves
    // the foot by 1e-16/h.
    EXPECT_LE(worst, std::min(thin, 1e-14 / thin) + 1e-14) << thin;
  }
}

TEST(TriangleProjection, OnAFaceInlineIsTheSameToTheBit)
{
  std::mt19937 random(4);
  int onFace = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Vector3 a = randomPoint(random, 1.0);
    const Vector3 b = randomPoint(random, 1.0);
    // Every fourth triangle is a sliver.
    const Vector3 c =
      i % 4 == 0 ? Vector3(b + 1e-6 * randomPoint(random, 1.0)) : randomPoint(random, 1.0);
    const Vector3 tip = randomPoint(random, 1.0);
    const TriangleProjection expected = projectOnTriangle(tip, a, b, c);
    TriangleProjection found;
    const PlaneFoot foot = projectOnFace(tip, a, b, c, found);
    if (foot == PlaneFoot::Unknown)
    {
      continue;
    }
    ASSERT_EQ(foot == PlaneFoot::OnFace, expected.feature == TriangleFeature::Face);
    if (foot == PlaneFoot::OnFace)
    {
      ++onFace;
      ASSERT_EQ(found.point, expected.point);
      ASSERT_EQ(found.weights, expected.weights);
      ASSERT_EQ(found.squaredDistance, expected.squaredDistance);
      ASSERT_EQ(found.feature, TriangleFeature::Face);
      continue;
    }
    // The foot on the plane is beyond this edge.
    const std::array<Vector3, 3> corner{ a, b, c };
    const auto edge = static_cast<std::size_t>(foot);
    const Vector3 along = corner[(edge + 1) % 3] - corner[edge];
    const Vector3 inward = (b - a).cross(c - a).cross(along);
    // rounding of products of lengths of about 1
    ASSERT_LE((tip - corner[edge]).dot(inward), 1e-12);
  }
  EXPECT_GT(onFace, 1000);
  TriangleProjection untouched;
  const Vector3 nowhere = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  const auto foot =
    projectOnFace(nowhere, Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY(), untouched);
  EXPECT_NE(foot, PlaneFoot::OnFace);
  EXPECT_EQ(untouched.squaredDistance, 0.0);
}
