// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/TriangleTree.h"

#include "BruteForce.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace palpate::testing;
using palpate::PackedMesh;
using palpate::SurfacePoint;
using palpate::TriangleTree;
using palpate::Vector3;

namespace
{
void compareWithAllTriangles(const Surface& given, int tips)
{
  const Surface body = given.rounded();
  const PackedMesh mesh = body.packed();
  const TriangleTree tree(mesh);
  const std::vector<std::int32_t> all = allTriangles(body);
  // Tolerance for the rounding of the coordinates.
  const double tolerance = 1e-12 * diagonal(body);
  const Eigen::AlignedBox3d box = boxOf(body);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-0.5, 1.5);
  for (int i = 0; i < tips; ++i)
  {
    Vector3 tip;
    for (int k = 0; k < 3; ++k)
    {
      tip[k] = box.min()[k] + share(random) * box.sizes()[k];
    }
    if (i % 10 == 0) // a point of the body itself, at the distance zero
    {
      tip = body.points[static_cast<std::size_t>(i) % body.points.size()];
    }
    const SurfacePoint found = tree.closest(tip);
    const Nearest nearest = nearestOf(body, tip, all);
    ASSERT_GE(found.triangle, 0);
    EXPECT_NEAR(std::abs(found.signedDistance), static_cast<double>(nearest.distance), tolerance);
    // The returned point is on the returned triangle at the returned distance.
    const Nearest there =
      nearestOf(body, found.projection.point, { mesh.inputTriangle(found.triangle) });
    EXPECT_LE(static_cast<double>(there.distance), tolerance);
    EXPECT_NEAR((tip - found.projection.point).norm(), std::abs(found.signedDistance), tolerance);
  }
}
} // namespace

TEST(TriangleTree, Convex)
{
  compareWithAllTriangles(icosphere(20.0, 3), 500);
}

TEST(TriangleTree, Concave)
{
  compareWithAllTriangles(torus(20.0, 6.0, 40, 20), 400);
  compareWithAllTriangles(subdivided(grooveBlock(), 2), 1000);
}

TEST(TriangleTree, FewTriangles)
{
  Surface one;
  one.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  one.triangles = { { 0, 1, 2 } };
  compareWithAllTriangles(one, 300);
  compareWithAllTriangles(angleBlock(), 2000);
}

TEST(TriangleTree, ManyTrianglesAtOnePlace)
{
  // Triangles with equal centres cannot be split by position; the construction must still end.
  Surface pile;
  for (std::int32_t i = 0; i < 300; ++i)
  {
    pile.points.insert(pile.points.end(), { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
    pile.triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  const PackedMesh mesh = pile.packed();
  EXPECT_EQ(TriangleTree(mesh).closest(Vector3(0.25, 0.25, 2.0)).signedDistance, 2.0);
}

TEST(TriangleTree, TipsThatAreNotFinite)
{
  const PackedMesh mesh = icosphere(20.0, 1).packed();
  const TriangleTree tree(mesh);
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    EXPECT_EQ(tree.closest(Vector3(0, bad, 0)).triangle, -1);
  }
}

TEST(TriangleTree, ATriangleForEveryFiniteTip)
{
  // Sizes and distances from those whose squares exceed a float to those whose squares vanish.
  constexpr double far = palpate::SoundMesh::LargestCoordinate;
  for (const double size : { 1e-40, 1e-20, 1.0, 1e10, 0.9 * far })
  {
    Surface body = icosphere(size, 1);
    const PackedMesh mesh = body.packed();
    ASSERT_EQ(mesh.triangleCount(), body.triangles.size()) << size;
    const TriangleTree tree(mesh);
    for (const double distance : { 0.0, 1e-300, 1e-30, size, 1e10, 1e20, 1e155, 1e308 })
    {
      const SurfacePoint found = tree.closest(Vector3(-distance, distance, 0.5 * distance));
      EXPECT_GE(found.triangle, 0) << size << ' ' << distance;
      // Tolerance: half of the body's size. The sphere has 80 facets, and at a large distance it is
      // nearly a point.
      EXPECT_NEAR(found.signedDistance, 1.5 * distance - size, 0.5 * size + 1e-9 * distance)
        << size << ' ' << distance;
    }
  }
}

TEST(TriangleTree, OnePointBeyondAllDoesNotSpoilTheBody)
{
  for (const double beyond : { 1.1e14, 1e20, 1e60, 1e308, -1e308 })
  {
    Surface body = icosphere(20.0, 1);
    body.points.emplace_back(beyond, 0.0, 0.0);
    body.triangles.push_back({ 0, 1, static_cast<std::int32_t>(body.points.size()) - 1 });
    const PackedMesh mesh = body.packed();
    EXPECT_EQ(mesh.defects().notFinite, 1U);
    EXPECT_EQ(mesh.centre(), Vector3::Zero());
    const Vector3 tip = 1.5 * body.points.front();
    // rounding of coordinates of 20 mm to floats
    EXPECT_NEAR(TriangleTree(mesh).closest(tip).signedDistance, 10.0, 1e-5) << beyond;
  }
}

TEST(TriangleTree, ABodyWhoseBoundsDoNotFitAFloat)
{
  // Sixth powers of these lengths overflow. One edge of the long triangle is the y axis. An
  // infinite bound must not hide the long triangle behind the other one. Either triangle may be
  // visited first.
  for (const double length : { 4e9, -4e9 })
  {
    Surface body;
    body.points = { { 0, -length, 0 }, { 4, -length, 0 }, { 0, length, 0 }, { 0, 0, 7 },
      { 4, 0, 7 }, { 0, 4, 7 } };
    body.triangles = { { 3, 4, 5 }, { 0, 1, 2 } };
    const PackedMesh mesh = body.packed();
    const SurfacePoint found = TriangleTree(mesh).closest(Vector3(-1.0, 0.5, 2.0));
    EXPECT_EQ(mesh.inputTriangle(found.triangle), 1);
    // 1e-12, because the centre of the mesh is a float near the body's centre; everything else is
    // exact.
    EXPECT_NEAR(std::abs(found.signedDistance), std::sqrt(5.0), 1e-12) << length;
  }
}
