// SPDX-License-Identifier: BSD-3-Clause
// Reversed, duplicate, split, thin and folded triangles are repaired or left out, and counted. The
// result has the closest points, sides and normals of the body without defects.
#include "BruteForce.h"
#include "BumpySphere.h"
#include "Contact/TriangleTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>

namespace palpate::testing
{
namespace
{
Surface withFlips(Surface body, std::size_t flips, unsigned seed)
{
  std::vector<std::size_t> order(body.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  for (std::size_t i = 0; i < flips; ++i)
  {
    std::swap(body.triangles[order[i]][0], body.triangles[order[i]][1]);
  }
  return body;
}

std::size_t count(const PackedMesh::Defects& defects)
{
  return defects.notFinite + defects.badIndex + defects.degenerate + defects.nonManifoldEdges +
    defects.borderEdges + defects.turnedTriangles + defects.joinedPoints;
}

/// Expects the distances, sides and normals of the body without defects at random tips in and
/// around it.
void expectSame(const PackedMesh& mended, const PackedMesh& sound, double reach)
{
  const TriangleTree tree(mended);
  const TriangleTree soundTree(sound);
  std::mt19937 random(21);
  std::uniform_real_distribution<double> place(-reach, reach);
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 tip = sound.centre() + Vector3(place(random), place(random), place(random));
    const SurfacePoint found = tree.closest(tip);
    const SurfacePoint expected = soundTree.closest(tip);
    // The coordinates are the same, but corners in another order cause other rounding.
    ASSERT_NEAR(found.signedDistance, expected.signedDistance, 1e-13 * reach);
    ASSERT_FALSE(found.onBorder);
  }
}

/// Expects the same unit normals at each input point. They are float32, summed in another order.
void expectSameNormals(const PackedMesh& mended, const PackedMesh& sound)
{
  std::vector<Vector3> expected(sound.pointCount());
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(sound.pointCount()); ++i)
  {
    expected[static_cast<std::size_t>(sound.inputPoint(i))] = sound.pointNormal(i);
  }
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(mended.pointCount()); ++i)
  {
    EXPECT_LE(
      (mended.pointNormal(i) - expected[static_cast<std::size_t>(mended.inputPoint(i))]).norm(),
      1e-6);
  }
}
} // namespace

TEST(PackedMeshRepair, SoundBodiesNeedNone)
{
  for (const Surface& body :
    { icosphere(20.0, 2), torus(20.0, 6.0, 12, 8), grooveBlock(), bumpySphere(20) })
  {
    EXPECT_EQ(count(body.packed().defects()), 0U);
  }
}

TEST(PackedMeshRepair, FlippedTrianglesAreTurnedOver)
{
  const Surface body = torus(20.0, 6.0, 40, 20); // 1600 triangles
  const PackedMesh sound = body.packed();
  for (const std::size_t flips : { 1, 40, 700 })
  {
    const PackedMesh mended = withFlips(body, flips, 5).packed();
    EXPECT_EQ(mended.defects().turnedTriangles, flips);
    EXPECT_EQ(count(mended.defects()), flips);
    expectSame(mended, sound, 27.0);
    expectSameNormals(mended, sound);
  }
}

TEST(PackedMeshRepair, ASoupIsJoined)
{
  const Surface body = icosphere(20.0, 3);
  const Surface apart = triangleSoup(body);
  const PackedMesh sound = body.packed();
  const PackedMesh mended = apart.packed();
  EXPECT_EQ(mended.defects().joinedPoints, apart.points.size() - body.points.size());
  EXPECT_EQ(count(mended.defects()), mended.defects().joinedPoints);
  EXPECT_EQ(mended.pointCount(), apart.points.size()); // each point keeps its own response
  expectSame(mended, sound, 25.0);
  // Each point at a position is linked to all triangles around this position.
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(mended.pointCount()); ++i)
  {
    int around = 0;
    mended.visitAround(i, [&](std::int32_t) { ++around; });
    EXPECT_GE(around, 5);
    EXPECT_LE(around, 6);
  }
}

TEST(PackedMeshRepair, AShuffledSoupWithFlipsAndScraps)
{
  Surface apart = withFlips(triangleSoup(bumpySphere(20)), 300, 8);
  const std::size_t triangles = apart.triangles.size();
  const auto n = static_cast<std::int32_t>(apart.points.size());
  apart.triangles.push_back({ 3, 4, 4 }); // the same corner twice
  apart.points.emplace_back(0, 0, std::nan(""));
  apart.triangles.push_back({ 5, 6, n }); // a point that is not finite
  const PackedMesh sound = bumpySphere(20).packed();
  for (const unsigned seed : { 1U, 2U, 3U })
  {
    Surface mixed = shuffled(apart, seed);
    mixed.triangles.push_back({ 0, n + 1, 1 }); // an index without a point
    const PackedMesh mended = mixed.packed();
    EXPECT_EQ(mended.triangleCount(), triangles);
    EXPECT_EQ(mended.defects().turnedTriangles, 300U);
    EXPECT_EQ(mended.defects().joinedPoints, 3 * triangles - sound.pointCount());
    EXPECT_EQ(mended.defects().badIndex, 1U);
    EXPECT_EQ(mended.defects().degenerate, 1U);
    EXPECT_EQ(mended.defects().notFinite, 1U);
    EXPECT_EQ(mended.defects().borderEdges + mended.defects().nonManifoldEdges, 0U);
    expectSame(mended, sound, 110.0);
  }
}

TEST(PackedMeshRepair, TheOrderOfTheInputDoesNotMatter)
{
  // 34 thousand triangles in another order, built with all cores: the neighbours and coordinates
  // are the same, and most neighbours are close in memory.
  const PackedMesh mesh = bumpySphere(65).packed();
  std::vector<std::int32_t> triangleOf;
  const PackedMesh other = shuffled(bumpySphere(65), 12, nullptr, &triangleOf).packed();
  ASSERT_EQ(mesh.triangleCount(), other.triangleCount());
  EXPECT_EQ(mesh.centre(), other.centre());
  const auto given = [&](std::int32_t t)
  { return triangleOf[static_cast<std::size_t>(other.inputTriangle(t))]; };
  std::vector<std::int32_t> placeOf(mesh.triangleCount());
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangleCount()); ++t)
  {
    placeOf[static_cast<std::size_t>(mesh.inputTriangle(t))] = t;
  }
  std::size_t nearLinks = 0;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(other.triangleCount()); ++t)
  {
    const std::int32_t same = placeOf[static_cast<std::size_t>(given(t))];
    int first = 0;
    while (first < 3 && other.corner(t, first) != mesh.corner(same, 0))
    {
      ++first;
    }
    ASSERT_LT(first, 3);
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(other.corner(t, (first + k) % 3), mesh.corner(same, k));
      ASSERT_EQ(
        given(other.neighbour(t, (first + k) % 3)), mesh.inputTriangle(mesh.neighbour(same, k)));
      nearLinks += std::abs(other.neighbour(t, k) - t) <= 32; // within 2 kB
    }
  }
  EXPECT_GT(nearLinks, 3 * mesh.triangleCount() * 3 / 4);
}

TEST(PackedMeshRepair, TrianglesWithoutAreaLeaveNoBorder)
{
  // A triangle whose three corners are on one line, as from a mesh generator that joined two
  // patches: (0,0)-(10,0) above, and (0,0)-(5,0)-(10,0) below.
  Surface seam;
  seam.points = { { 0, 0, 0 }, { 10, 0, 0 }, { 5, 8, 0 }, { 5, -8, 0 }, { 5, 0, 0 } };
  seam.triangles = { { 0, 1, 2 }, { 0, 3, 4 }, { 3, 1, 4 }, { 0, 4, 1 } };
  const PackedMesh mesh = seam.packed();
  EXPECT_EQ(mesh.triangleCount(), 3U);
  EXPECT_EQ(mesh.defects().degenerate, 1U);
  EXPECT_EQ(mesh.defects().borderEdges, 4U); // the outer border
  EXPECT_EQ(mesh.defects().nonManifoldEdges, 0U);
  const TriangleTree tree(mesh);
  for (const double x : { 1.0, 5.0, 7.3 })
  {
    const SurfacePoint found = tree.closest(Vector3(x, 0.0, -1.0));
    EXPECT_EQ(found.signedDistance, -1.0);
    EXPECT_FALSE(found.onBorder) << x;
  }
  EXPECT_TRUE(tree.closest(Vector3(-1.0, 0.0, -1.0)).onBorder);
}

TEST(PackedMeshRepair, AreaLostInRoundingIsLeftOut)
{
  // A sliver 1e-7 mm high in a body 20 mm long has an area in double precision, but not in float32.
  Surface body = block(20, 20, 20);
  const auto n = static_cast<std::int32_t>(body.points.size());
  body.points.insert(body.points.end(), { { 30.1, 0, 0 }, { 30.3, 0, 0 }, { 30.2, 1e-7, 1e-7 } });
  body.triangles.push_back({ n, n + 1, n + 2 });
  EXPECT_EQ(body.packed().defects().degenerate, 1U);
  EXPECT_EQ(body.packed().triangleCount(), 12U);
  body.points.back() = { 30.2, 1e-4, 1e-4 };
  EXPECT_EQ(body.packed().defects().degenerate, 0U);
}

TEST(PackedMeshRepair, CoordinatesAreOffByHalfAnUlp)
{
  // The accuracy that the header states: 2^-25 of the distance from the centre, rounded up to a
  // power of two.
  const Surface body = bumpySphere(20);
  const PackedMesh mesh = body.packed();
  double worst = 0.0;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangleCount()); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vector3 local = body.corner(mesh.inputTriangle(t), k) - mesh.centre();
      const Vector3 error = mesh.corner(t, static_cast<int>(k)) - local;
      worst = std::max(worst, error.cwiseAbs().maxCoeff());
    }
  }
  EXPECT_LE(worst, 128.0 / (1 << 25)); // 3.8e-6 mm
  EXPECT_GE(worst, 128.0 / (1 << 27)); // the bound is tight: some of the 4000 points are near it
}
} // namespace palpate::testing
