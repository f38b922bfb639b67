// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/MeshRepair.h"

#include "SampleBodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace palpate::testing
{
namespace
{
/// A strip of `n` squares whose ends are joined, with half a twist if `twisted`.
std::vector<TriangleCorners> band(std::int32_t n, bool twisted)
{
  std::vector<TriangleCorners> triangles;
  for (std::int32_t i = 0; i < n; ++i)
  {
    const bool last = i + 1 == n;
    const std::int32_t low = last ? (twisted ? 1 : 0) : 2 * i + 2;
    const std::int32_t high = last ? (twisted ? 0 : 1) : 2 * i + 3;
    triangles.push_back({ 2 * i, low, 2 * i + 1 });
    triangles.push_back({ 2 * i + 1, low, high });
  }
  return triangles;
}

TriangleCorners turned(const TriangleCorners& t)
{
  return { t[0], t[2], t[1] };
}

std::size_t twisted(const std::vector<TriangleCorners>& triangles, std::size_t points)
{
  return TriangleLinks(triangles, points).twistedEdges();
}

std::vector<std::int32_t> twinsOf(const Surface& body)
{
  std::vector<float> coordinates;
  for (const Vector3& p : body.points)
  {
    for (const double x : p)
    {
      coordinates.push_back(static_cast<float>(x));
    }
  }
  return findTwins(
    coordinates.data(), body.points.size(), TriangleLinks(body.triangles, body.points.size()));
}

std::size_t joined(const std::vector<std::int32_t>& twins)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < twins.size(); ++i)
  {
    count += twins[i] != static_cast<std::int32_t>(i);
  }
  return count;
}
} // namespace

TEST(MeshRepair, NothingToTurn)
{
  for (const Surface& body : { icosphere(20.0, 2), torus(20.0, 6.0, 12, 8), openPlate(10.0, 4) })
  {
    std::vector<TriangleCorners> triangles = body.triangles;
    EXPECT_EQ(makeWindingConsistent(triangles), 0U);
    EXPECT_EQ(triangles, body.triangles);
  }
}

TEST(MeshRepair, TheFewerAreTurned)
{
  const Surface body = icosphere(20.0, 2); // 320 triangles
  for (const std::size_t flips : { 1, 17, 150 })
  {
    std::vector<std::size_t> order(body.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(9));
    std::vector<TriangleCorners> triangles = body.triangles;
    for (std::size_t i = 0; i < flips; ++i)
    {
      triangles[order[i]] = turned(triangles[order[i]]);
    }
    EXPECT_GT(twisted(triangles, body.points.size()), 0U);
    EXPECT_EQ(makeWindingConsistent(triangles), flips);
    EXPECT_EQ(triangles, body.triangles);
  }
}

TEST(MeshRepair, MoreThanHalfTurnsTheRest)
{
  // The majority does not determine which side is outside: with 200 of 320 triangles reversed the
  // result is consistent but inside out.
  const Surface body = icosphere(20.0, 2);
  std::vector<TriangleCorners> triangles = body.triangles;
  std::transform(triangles.begin(), triangles.begin() + 200, triangles.begin(), turned);
  EXPECT_EQ(makeWindingConsistent(triangles), 120U);
  EXPECT_EQ(twisted(triangles, body.points.size()), 0U);
}

TEST(MeshRepair, EachPartByItself)
{
  // A box with one reversed triangle, and a box of which all triangles are reversed. The second box
  // is consistent and stays unchanged.
  Surface body = block(3, 4, 5);
  const std::size_t half = body.triangles.size();
  const auto shift = static_cast<std::int32_t>(body.points.size());
  std::vector<TriangleCorners> triangles = body.triangles;
  for (std::size_t t = 0; t < half; ++t)
  {
    const TriangleCorners corner = turned(body.triangles[t]);
    triangles.push_back({ corner[0] + shift, corner[1] + shift, corner[2] + shift });
  }
  const std::vector<TriangleCorners> wanted = triangles;
  triangles[5] = turned(triangles[5]);
  EXPECT_EQ(makeWindingConsistent(triangles), 1U);
  EXPECT_EQ(triangles, wanted);
}

TEST(MeshRepair, AMoebiusBandIsLeftAlone)
{
  std::vector<TriangleCorners> ring = band(9, false);
  std::vector<TriangleCorners> moebius = band(9, true);
  EXPECT_EQ(twisted(ring, 18), 0U);
  EXPECT_EQ(twisted(moebius, 18), 1U);
  const std::vector<TriangleCorners> given = moebius;
  EXPECT_EQ(makeWindingConsistent(moebius), 0U);
  EXPECT_EQ(moebius, given);
  // With one triangle reversed in both bands, it is reversed back in the ring, and the twisted band
  // stays unchanged.
  ring[4] = turned(ring[4]);
  moebius[4] = turned(moebius[4]);
  EXPECT_EQ(makeWindingConsistent(ring), 1U);
  EXPECT_EQ(ring, band(9, false));
  EXPECT_EQ(makeWindingConsistent(moebius), 0U);
  EXPECT_EQ(moebius[4], turned(given[4]));
}

TEST(MeshRepair, NotAcrossEdgesOfThree)
{
  // A fin on a plate: it is unknown which of the three triangles belong together, so the fin keeps
  // its orientation.
  std::vector<TriangleCorners> triangles{ { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 }, { 1, 5, 4 } };
  const std::vector<TriangleCorners> given = triangles;
  EXPECT_EQ(makeWindingConsistent(triangles), 0U);
  EXPECT_EQ(triangles, given);
}

TEST(MeshRepair, ASoupIsJoined)
{
  const Surface body = icosphere(20.0, 2);
  const Surface apart = triangleSoup(body);
  const std::vector<std::int32_t> twins = twinsOf(apart);
  EXPECT_EQ(joined(twins), apart.points.size() - body.points.size());
  for (std::size_t i = 0; i < twins.size(); ++i)
  {
    const auto first = static_cast<std::size_t>(twins[i]);
    EXPECT_LE(first, i);
    EXPECT_EQ(static_cast<std::size_t>(twins[first]), first);
    EXPECT_EQ(apart.points[first], apart.points[i]);
  }
}

TEST(MeshRepair, OnlyBordersAreJoined)
{
  // Two closed boxes with a face at the same place have four common positions, but each box is
  // complete.
  Surface boxes = block(3, 4, 5);
  const Surface other = boxes;
  const auto shift = static_cast<std::int32_t>(boxes.points.size());
  for (const Vector3& p : other.points)
  {
    boxes.points.push_back(p + Vector3(3, 0, 0));
  }
  for (const auto& t : other.triangles)
  {
    boxes.triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
  EXPECT_EQ(joined(twinsOf(boxes)), 0U);
  // In a plate that is cut in two only the cut is joined. A point without a triangle is never
  // joined.
  Surface halves = openPlate(10.0, 2);
  const auto middle = static_cast<std::int32_t>(halves.points.size());
  for (int j = 0; j <= 2; ++j)
  {
    const Vector3 onCut = halves.points[static_cast<std::size_t>(3 + j)];
    halves.points.push_back(onCut);
  }
  const Vector3 onCut = halves.points[4];
  halves.points.push_back(onCut); // a point of no triangle
  for (std::size_t t = 4; t < 8; ++t)
  {
    for (std::int32_t& corner : halves.triangles[t])
    {
      corner = corner >= 3 && corner <= 5 ? corner - 3 + middle : corner;
    }
  }
  const std::vector<std::int32_t> twins = twinsOf(halves);
  EXPECT_EQ(joined(twins), 3U);
  for (std::int32_t j = 0; j < 3; ++j)
  {
    EXPECT_EQ(twins[static_cast<std::size_t>(middle + j)], 3 + j);
  }
}

TEST(MeshRepair, PointsApartByLessThanAFloatAreOne)
{
  Surface halves;
  halves.points = { { 1, 0, 0 }, { 1, 1, 0 }, { 0, 0, 0 }, { 1 + 1e-9, 0, 0 },
    { 1, 1 + 1e-9, -0.0 }, { 2, 0, 0 } };
  halves.triangles = { { 0, 1, 2 }, { 4, 3, 5 } };
  EXPECT_EQ(twinsOf(halves), (std::vector<std::int32_t>{ 0, 1, 2, 0, 1, 5 }));
}

TEST(MeshRepair, EndsOfEmptyEdgesAreJoined)
{
  // Six points at two positions. Triangles without area connect 0 to 2, 2 to 4, and 1 to 5. Point 3
  // is not connected, nor is point 6, which is at another position.
  const std::vector<float> at{ 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0 };
  const std::vector<TriangleCorners> empty{ { 4, 2, 3 }, { 2, 0, 6 }, { 5, 1, 6 } };
  const auto joinAll = [&](std::vector<std::int32_t> first)
  {
    for (const TriangleCorners& corners : empty)
    {
      joinEmptyEdges(at.data(), corners, first);
    }
    followJoints(first);
    return first;
  };
  EXPECT_EQ(joinAll({ 0, 1, 2, 3, 4, 5, 6 }), (std::vector<std::int32_t>{ 0, 1, 0, 3, 0, 1, 6 }));
  // Points that were joined before stay joined.
  EXPECT_EQ(joinAll({ 0, 1, 2, 1, 4, 5, 6 }), (std::vector<std::int32_t>{ 0, 1, 0, 1, 0, 1, 6 }));
}
} // namespace palpate::testing
