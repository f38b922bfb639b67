// SPDX-License-Identifier: BSD-3-Clause
// The gap of a triangulated body against that of the smooth body from which its points were taken:
// random ellipsoids with bumps. The sides of their triangles are between half and three times the
// width of the contact.
#include "Solids/Curves/GapOfSurface.h"

#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <utility>

namespace
{
using namespace palpate;

/// A triangulated ball of radius 1 whose points are moved a little along its surface.
struct Ball
{
  std::vector<Vector3> points;
  std::vector<TriangleCorners> triangles;
};

Ball makeBall(int divisions, std::mt19937& random)
{
  Ball ball;
  const double t = 0.5 * (1.0 + std::sqrt(5.0));
  for (const double a : { -1.0, 1.0 })
  {
    for (const double b : { -t, t })
    {
      ball.points.push_back(Vector3(a, b, 0.0).normalized());
      ball.points.push_back(Vector3(0.0, a, b).normalized());
      ball.points.push_back(Vector3(b, 0.0, a).normalized());
    }
  }
  // Each face of an icosahedron is a triple of neighbouring points.
  const double side = 2.0 / std::sqrt(1.0 + t * t);
  const auto isSide = [&](std::int32_t i, std::int32_t j)
  {
    return std::abs(
             (ball.points[static_cast<std::size_t>(i)] - ball.points[static_cast<std::size_t>(j)])
               .norm() -
             side) < 1e-9;
  };
  for (std::int32_t i = 0; i < 12; ++i)
  {
    for (std::int32_t j = i + 1; j < 12; ++j)
    {
      for (std::int32_t k = j + 1; k < 12; ++k)
      {
        if (isSide(i, j) && isSide(j, k) && isSide(i, k))
        {
          const auto at = [&](std::int32_t n) { return ball.points[static_cast<std::size_t>(n)]; };
          const bool turned = (at(j) - at(i)).cross(at(k) - at(i)).dot(at(i)) < 0.0;
          ball.triangles.push_back(
            turned ? TriangleCorners{ i, k, j } : TriangleCorners{ i, j, k });
        }
      }
    }
  }
  for (int d = 0; d < divisions; ++d)
  {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
    const auto middle = [&](std::int32_t a, std::int32_t b)
    {
      const auto [found, isNew] =
        middles.insert({ std::minmax(a, b), static_cast<std::int32_t>(ball.points.size()) });
      if (isNew)
      {
        const Vector3 sum =
          ball.points[static_cast<std::size_t>(a)] + ball.points[static_cast<std::size_t>(b)];
        ball.points.push_back(sum.normalized());
      }
      return found->second;
    };
    std::vector<TriangleCorners> finer;
    for (const TriangleCorners& c : ball.triangles)
    {
      const TriangleCorners m = { middle(c[0], c[1]), middle(c[1], c[2]), middle(c[2], c[0]) };
      finer.push_back({ c[0], m[0], m[2] });
      finer.push_back({ c[1], m[1], m[0] });
      finer.push_back({ c[2], m[2], m[1] });
      finer.push_back(m);
    }
    ball.triangles = std::move(finer);
  }
  const double length =
    std::sqrt(16.0 * Pi / std::sqrt(3.0) / static_cast<double>(ball.triangles.size()));
  std::uniform_real_distribution<double> shift(-0.2 * length, 0.2 * length);
  for (Vector3& point : ball.points)
  {
    point = (point + Vector3(shift(random), shift(random), shift(random))).normalized();
  }
  return ball;
}

using Implicit = std::function<double(const Vector3&)>; // > 0 outside the body

/// An ellipsoid with bumps. `highest`: height of the bumps / radius of the body; `largest`: largest
/// number of waves per radius.
Implicit bumpyEllipsoid(double highest, double largest, std::mt19937& random)
{
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const double radius = 12.0 + 10.0 * std::abs(any(random));
  const Vector3 axes =
    radius * (Vector3::Ones() + 0.4 * Vector3(any(random), any(random), any(random)));
  const double height = highest * std::abs(any(random));
  const Vector3 wave = largest * Vector3(any(random), any(random), any(random));
  const double phase = 3.0 * any(random);
  return [=](const Vector3& at)
  {
    const Vector3 scaled = at.cwiseQuotient(axes);
    const double r = scaled.norm();
    return r - 1.0 - height * std::sin(wave.dot(scaled) / r + phase);
  };
}

/// Distance t at which the line from + t direction enters the body. The point at `first` is
/// outside.
double crossing(
  const Implicit& body, const Vector3& from, const Vector3& direction, double first, double last)
{
  const double step = (last - first) / 200.0;
  double low = first;
  while (low < last && body(from + (low + step) * direction) > 0.0)
  {
    low += step;
  }
  double high = low + step;
  for (int i = 0; i < 40; ++i)
  {
    const double middle = 0.5 * (low + high);
    (body(from + middle * direction) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The mean of (r/a)^2m under the pressure of a flat punch, which changes the force.
double feltMean(const GapTerms& gap)
{
  return gap.drop[0] + 2.0 / 3.0 * gap.drop[1] + 8.0 / 15.0 * gap.drop[2];
}

constexpr double LeftOfFacets = 1.0 / 3.0; // the same fraction as in ShapedContact

/// Number of gaps compared with those of the smooth bodies, number of differences above the stated
/// error, and the median of difference / gap.
struct Compared
{
  int all = 0;
  int beyond = 0;
  double median = 0.0;
};

Compared compareGaps(double highest, double largest)
{
  std::mt19937 random(3);
  Compared compared;
  std::vector<double> ratios;
  for (int b = 0; b < 16; ++b)
  {
    Ball ball = makeBall(2 + b % 2, random);
    const Implicit body = bumpyEllipsoid(highest, largest, random);
    std::vector<double> points;
    std::vector<std::int32_t> triangles;
    for (Vector3& point : ball.points)
    {
      point *= 100.0 - crossing(body, 100.0 * point, -point, 0.0, 100.0);
      points.insert(points.end(), point.data(), point.data() + 3);
    }
    double side = 0.0;
    for (const TriangleCorners& c : ball.triangles)
    {
      triangles.insert(triangles.end(), c.begin(), c.end());
      side +=
        (ball.points[static_cast<std::size_t>(c[1])] - ball.points[static_cast<std::size_t>(c[0])])
          .norm() /
        static_cast<double>(ball.triangles.size());
    }
    const BodyMesh mesh(points.data(), ball.points.size(), triangles.data(), ball.triangles.size());
    std::vector<float> normals;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(mesh.pointCount()); ++i)
    {
      const Vector3 normal = mesh.pointNormal(i);
      normals.insert(normals.end(), normal.data(), normal.data() + 3);
    }
    for (const double part : { 0.3, 0.6, 1.2 })
    {
      const double a = part * side;
      for (std::size_t i = 0; i < ball.points.size(); i += 1 + ball.points.size() / 40)
      {
        const Eigen::Matrix3d frame = SurfaceGap::frame(
          Eigen::Map<const Eigen::Vector3f>(normals.data() + 3 * i).cast<double>());
        SurfaceGap::Heights heights;
        for (int k = 0; k < SurfaceGap::Rings; ++k)
        {
          for (int j = 0; j < SurfaceGap::Angles; ++j)
          {
            const double angle = 2.0 * Pi * j / SurfaceGap::Angles;
            const Vector3 at = ball.points[i] +
              a * SurfaceGap::ring(k) *
                (std::cos(angle) * frame.col(0) + std::sin(angle) * frame.col(1));
            heights.surface(k, j) = crossing(body, at, frame.col(2), -3.0 * side, 3.0 * side);
          }
        }
        heights.facets = heights.surface;
        const GapTerms truth = SurfaceGap(a, heights).at(a);
        const SurfaceGap gap = gapOfSurface(mesh, normals.data(), static_cast<std::int32_t>(i), a);
        if (!gap.isWhole())
        {
          continue;
        }
        const GapTerms found = gap.at(a);
        ++compared.all;
        const double error = std::abs(feltMean(found) - feltMean(truth));
        const double stated = LeftOfFacets * std::sqrt(found.facets * found.uneven);
        compared.beyond += error > stated ? 1 : 0;
        ratios.push_back(error / std::max(feltMean(truth), 1e-3));
      }
    }
  }
  std::sort(ratios.begin(), ratios.end());
  compared.median = ratios[ratios.size() / 2];
  std::cout << compared.beyond << " of " << compared.all
            << " beyond what is stated; half of all within " << compared.median << " of the gap\n";
  return compared;
}
} // namespace

// The points resolve the bumps, which are at least as long as some triangles.
TEST(GapOfSurface, IsThatOfTheSmoothBody)
{
  const Compared compared = compareGaps(0.06, 6.0);
  EXPECT_GT(compared.all, 1000);
  EXPECT_LE(compared.beyond, 0.05 * compared.all);
  EXPECT_LT(compared.median, 0.05);
}

// The bumps are shorter than the distances of the points.
TEST(GapOfSurface, SaysWhatThePointsLeaveOpen)
{
  const Compared compared = compareGaps(0.08, 12.0);
  EXPECT_GT(compared.all, 1000);
  EXPECT_LE(compared.beyond, 0.05 * compared.all);
}

// Beyond the rim of a can no surface has the same orientation.
TEST(GapOfSurface, EndsAtAnEdge)
{
  std::vector<double> points;
  std::vector<std::int32_t> triangles;
  constexpr int n = 8;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      points.insert(points.end(), { 1.0 * i, 1.0 * j, 0.0 });
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const std::int32_t a = i * (n + 1) + j;
      triangles.insert(triangles.end(), { a, a + n + 1, a + 1, a + n + 1, a + n + 2, a + 1 });
    }
  }
  const BodyMesh mesh(points.data(), points.size() / 3, triangles.data(), triangles.size() / 3);
  std::vector<float> normals;
  for (std::size_t i = 0; i < mesh.pointCount(); ++i)
  {
    normals.insert(normals.end(), { 0.0F, 0.0F, 1.0F });
  }
  const auto at = [](int i, int j) { return i * (n + 1) + j; };
  const SurfaceGap middle = gapOfSurface(mesh, normals.data(), at(4, 4), 3.0);
  EXPECT_TRUE(middle.isWhole());
  EXPECT_TRUE(middle.at(2.0).drop.isZero(1e-12));
  EXPECT_LT(middle.at(2.0).waves, 1e-20);
  const SurfaceGap beside = gapOfSurface(mesh, normals.data(), at(1, 4), 3.0);
  EXPECT_FALSE(beside.isWhole());
  EXPECT_LE(beside.reach(), 1.0);
  EXPECT_GT(beside.reach(), 0.8);
  EXPECT_EQ(gapOfSurface(mesh, normals.data(), at(0, 4), 3.0).reach(), 0.0);
}
