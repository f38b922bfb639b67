// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/TriangleLinks.h"

#include "BumpySphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace palpate::testing
{
namespace
{
std::vector<std::int32_t> ringOf(const TriangleLinks& topology, std::int32_t point)
{
  const auto ends = topology.around(point);
  return { ends[0], ends[1] };
}

/// The triangle along each half edge, by enumeration.
std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> halfEdgesOf(const Surface& body)
{
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> halfEdges;
  for (std::size_t t = 0; t < body.triangles.size(); ++t)
  {
    for (std::size_t e = 0; e < 3; ++e)
    {
      halfEdges[{ body.triangles[t][e], body.triangles[t][(e + 1) % 3] }] =
        static_cast<std::int32_t>(t);
    }
  }
  return halfEdges;
}

void expectNeighboursByHalfEdges(const Surface& body)
{
  const TriangleLinks topology(body.triangles, body.points.size());
  const auto halfEdges = halfEdgesOf(body);
  for (std::size_t t = 0; t < body.triangles.size(); ++t)
  {
    for (std::size_t e = 0; e < 3; ++e)
    {
      const auto across = halfEdges.find({ body.triangles[t][(e + 1) % 3], body.triangles[t][e] });
      ASSERT_EQ(topology.neighbours(t)[e],
        across == halfEdges.end() ? TriangleLinks::Border : across->second);
    }
  }
}
} // namespace

TEST(TriangleLinks, TwoTriangles)
{
  const TriangleLinks topology({ { 0, 1, 2 }, { 2, 1, 3 } }, 5);
  EXPECT_EQ(topology.neighbours(0), (std::array<std::int32_t, 3>{ -1, 1, -1 }));
  EXPECT_EQ(topology.neighbours(1), (std::array<std::int32_t, 3>{ 0, -1, -1 }));
  EXPECT_EQ(ringOf(topology, 0), (std::vector<std::int32_t>{ 0 }));
  EXPECT_EQ(ringOf(topology, 1), (std::vector<std::int32_t>{ 0, 1 }));
  EXPECT_EQ(ringOf(topology, 2), (std::vector<std::int32_t>{ 0, 1 }));
  EXPECT_EQ(ringOf(topology, 3), (std::vector<std::int32_t>{ 1 }));
  EXPECT_TRUE(ringOf(topology, 4).empty());
  EXPECT_EQ(topology.borderEdges(), 4U);
  EXPECT_EQ(topology.nonManifoldEdges(), 0U);
  EXPECT_EQ(topology.twistedEdges(), 0U);
  EXPECT_TRUE(topology.onBorder(3));
  EXPECT_FALSE(topology.onBorder(4));
}

TEST(TriangleLinks, TwoTrianglesThatWindApart)
{
  // Both triangles have an edge from 1 to 2, so they are not neighbours. Reversing one of them
  // would repair this.
  const TriangleLinks topology({ { 0, 1, 2 }, { 1, 2, 3 } }, 4);
  EXPECT_EQ(topology.neighbours(0)[1], TriangleLinks::NonManifold);
  EXPECT_EQ(topology.neighbours(1)[0], TriangleLinks::NonManifold);
  EXPECT_EQ(topology.nonManifoldEdges(), 1U);
  EXPECT_EQ(topology.twistedEdges(), 1U);
  EXPECT_EQ(topology.borderEdges(), 4U);
}

TEST(TriangleLinks, EdgesOfMoreThanTwoTriangles)
{
  const TriangleLinks fins({ { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }, 5);
  for (std::size_t t = 0; t < 3; ++t)
  {
    EXPECT_EQ(fins.neighbours(t)[0], TriangleLinks::NonManifold);
  }
  EXPECT_EQ(fins.nonManifoldEdges(), 1U);
  EXPECT_EQ(fins.twistedEdges(), 0U); // reversing a triangle does not repair this edge
  EXPECT_EQ(fins.borderEdges(), 6U);
  // The same triangle twice; and a triangle and its reverse, which form a closed surface.
  EXPECT_EQ(TriangleLinks({ { 0, 1, 2 }, { 0, 1, 2 } }, 3).nonManifoldEdges(), 3U);
  const TriangleLinks leaf({ { 0, 1, 2 }, { 0, 2, 1 } }, 3);
  EXPECT_EQ(leaf.nonManifoldEdges() + leaf.borderEdges(), 0U);
  EXPECT_EQ(leaf.neighbours(0), (std::array<std::int32_t, 3>{ 1, 1, 1 }));
}

TEST(TriangleLinks, TrianglesThatTakeNoPart)
{
  const TriangleLinks topology({ { 0, 1, 2 }, { -1, 1, 3 }, { 2, 1, 3 } }, 4);
  EXPECT_EQ(topology.neighbours(0)[1], 2);
  EXPECT_EQ(topology.neighbours(1), (std::array<std::int32_t, 3>{ -1, -1, -1 }));
  EXPECT_EQ(topology.borderEdges(), 4U);
  EXPECT_EQ(ringOf(topology, 3), (std::vector<std::int32_t>{ 2 }));
}

TEST(TriangleLinks, LargerSurfaces)
{
  expectNeighboursByHalfEdges(torus(20.0, 6.0, 12, 8));
  expectNeighboursByHalfEdges(openPlate(10.0, 7));
  // 34 thousand triangles, with all cores.
  expectNeighboursByHalfEdges(shuffled(bumpySphere(65), 4));
  const Surface plate = openPlate(10.0, 7);
  const TriangleLinks topology(plate.triangles, plate.points.size());
  EXPECT_EQ(topology.borderEdges(), 28U);
  for (std::size_t i = 0; i < plate.points.size(); ++i)
  {
    const Vector3& p = plate.points[i];
    const bool onRim = p.x() == 0.0 || p.y() == 0.0 || p.x() == 10.0 || p.y() == 10.0;
    EXPECT_EQ(topology.onBorder(static_cast<std::int32_t>(i)), onRim);
  }
}
} // namespace palpate::testing
