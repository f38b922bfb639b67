// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that are cut along their sharp edges: which edges are sharp, which points are cut, and
// which parts are unchanged.
#include "SampleBodies.h"
#include "Contact/Edges/BodyEdges.h"
#include "Contact/PackedMesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <set>

namespace palpate::testing
{
namespace
{
PackedMesh withCreases(const Surface& body, bool areCut)
{
  return PackedMesh(body.points.front().data(), body.points.size(), body.triangles.front().data(),
    body.triangles.size(), {}, { BodyEdges::LeastTurn, areCut });
}

PackedMesh cut(const Surface& body)
{
  return withCreases(body, true);
}

/// Compares the folded triangles with those that have a corner at a place of a crease.
template <class IsOnCrease>
void expectFolded(const PackedMesh& mesh, const IsOnCrease& isOnCrease)
{
  std::size_t folded = 0;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangleCount()); ++t)
  {
    bool isExpected = false;
    for (int k = 0; k < 3; ++k)
    {
      isExpected = isExpected || isOnCrease(Vector3(mesh.corner(t, k) + mesh.centre()));
    }
    EXPECT_EQ(mesh.isFolded(t), isExpected) << t;
    folded += isExpected ? 1 : 0;
  }
  EXPECT_GT(folded, 0U);
  EXPECT_LT(folded, mesh.triangleCount());
}

/// A prism over a regular polygon of radius 10 mm, 10 mm high, with each triangle split into
/// 4^times.
Surface polygonPrism(int corners, int times)
{
  std::vector<Eigen::Vector2d> polygon;
  std::vector<std::array<std::int32_t, 3>> caps;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * M_PI * i / corners;
    polygon.emplace_back(10.0 * std::cos(angle), 10.0 * std::sin(angle));
  }
  for (std::int32_t i = 1; i + 1 < corners; ++i)
  {
    caps.push_back({ 0, i, i + 1 });
  }
  return subdivided(prism(polygon, caps, 10.0), times);
}

/// Separate corners for each triangle, as in an STL file.
Surface inFacets(const Surface& body)
{
  Surface apart;
  for (const auto& corners : body.triangles)
  {
    const auto first = static_cast<std::int32_t>(apart.points.size());
    for (const std::int32_t corner : corners)
    {
      apart.points.push_back(body.points[static_cast<std::size_t>(corner)]);
    }
    apart.triangles.push_back({ first, first + 1, first + 2 });
  }
  return apart;
}

double area(const PackedMesh& mesh)
{
  double sum = 0.0;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangleCount()); ++t)
  {
    sum += 0.5 * mesh.areaNormal(t).norm();
  }
  return sum;
}
} // namespace

TEST(CreaseCut, ABlockFallsIntoItsSixSides)
{
  const Surface body = subdivided(block(20.0, 15.0, 10.0), 3);
  const PackedMesh mesh = cut(body);
  // 12 edges of 8 sides each, counted for both faces.
  EXPECT_EQ(mesh.creases().size(), 2U * 12U * 8U);
  // A point on an edge becomes two points, a corner becomes three.
  EXPECT_EQ(mesh.pointCount(), body.points.size() + 12U * 7U + 8U * 2U);
  EXPECT_EQ(mesh.inputPointCount(), body.points.size());
  EXPECT_EQ(mesh.defects().borderEdges, 0U) << "a crease is no border";
  EXPECT_NEAR(area(mesh), 2.0 * (300.0 + 200.0 + 150.0), 1e-9);
  for (const PackedMesh::CreaseSide& side : mesh.creases())
  {
    EXPECT_NEAR(static_cast<double>(side.turn), 0.5 * M_PI, 1e-6);
    EXPECT_EQ(mesh.neighbour(side.triangle, side.edge), PackedMesh::Crease);
    EXPECT_LT(mesh.faceNormal(side.triangle).dot(mesh.faceNormal(side.across)), 1e-6);
  }
  // Each point has the normal of its face, and the triangles around the point belong to this face.
  for (std::int32_t point = 0; point < static_cast<std::int32_t>(mesh.pointCount()); ++point)
  {
    mesh.visitAround(point,
      [&](std::int32_t triangle)
      { EXPECT_NEAR(mesh.pointNormal(point).dot(mesh.faceNormal(triangle)), 1.0, 1e-6); });
  }
}

TEST(CreaseCut, TheSameOfFacetsThatShareNoPoint)
{
  const Surface body = subdivided(block(20.0, 15.0, 10.0), 2);
  const PackedMesh mesh = cut(inFacets(body));
  EXPECT_EQ(mesh.creases().size(), cut(body).creases().size());
  EXPECT_EQ(mesh.defects().borderEdges, 0U);
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangleCount()); ++t)
  {
    for (const std::int32_t point : mesh.corners(t))
    {
      EXPECT_NEAR(mesh.pointNormal(point).dot(mesh.faceNormal(t)), 1.0, 1e-6);
      EXPECT_LT(mesh.inputPoint(point), static_cast<std::int32_t>(3 * mesh.triangleCount()));
    }
  }
}

TEST(CreaseCut, ACoarseBallHasNoFaces)
{
  for (const int times : { 0, 1, 2, 3 })
  {
    const Surface ball = icosphere(10.0, times);
    const PackedMesh mesh = cut(ball);
    EXPECT_TRUE(mesh.creases().empty()) << times; // even facets of 42° and 21° are not sharp edges
    EXPECT_EQ(mesh.pointCount(), ball.points.size());
  }
}

TEST(CreaseCut, OnlyTheRimsOfACylinder)
{
  // The sides meet at 5.6°, the rims at 90°.
  EXPECT_EQ(cut(polygonPrism(64, 1)).creases().size(), 2U * 2U * 128U);
  // The sides of a hexagonal prism meet at 60°, which is a sharp edge.
  EXPECT_EQ(cut(polygonPrism(6, 2)).creases().size(), 2U * (2U * 24U + 6U * 4U));
}

TEST(CreaseCut, InnerEdgesAreNone)
{
  const PackedMesh mesh = cut(subdivided(angleBlock(), 2));
  for (const PackedMesh::CreaseSide& side : mesh.creases())
  {
    const Vector3 along =
      mesh.corner(side.triangle, (side.edge + 1) % 3) - mesh.corner(side.triangle, side.edge);
    EXPECT_GT(mesh.faceNormal(side.triangle).cross(mesh.faceNormal(side.across)).dot(along), 0.0);
  }
  EXPECT_EQ(mesh.creases().size(), 2U * 4U * (2U * 6U + 5U)); // 6 sides, 5 of 6 vertical edges
}

TEST(CreaseCut, BordersStayBorders)
{
  // A roof of 90° with a border all around.
  Surface roof = openPlate(10.0, 10);
  for (Vector3& point : roof.points)
  {
    point.z() = -std::abs(point.x() - 5.0);
  }
  const PackedMesh mesh = cut(roof);
  EXPECT_EQ(mesh.creases().size(), 2U * 10U);
  EXPECT_EQ(mesh.defects().borderEdges, 40U);
}

TEST(CreaseCut, TrianglesAtCreasesThatAreNotCutAreFolded)
{
  const double apothem = 10.0 * std::cos(M_PI / 6.0);
  const auto isOnPrismEdge = [apothem](const Vector3& at)
  {
    int faces = std::abs(at.z()) < 1e-6 || std::abs(at.z() - 10.0) < 1e-6 ? 1 : 0;
    for (int i = 0; i < 6; ++i)
    {
      const double angle = (2.0 * i + 1.0) * M_PI / 6.0;
      faces += std::abs(std::cos(angle) * at.x() + std::sin(angle) * at.y() - apothem) < 1e-5;
    }
    return faces > 1;
  };
  const PackedMesh prism = withCreases(polygonPrism(6, 3), false);
  EXPECT_TRUE(prism.creases().empty());
  expectFolded(prism, isOnPrismEdge);
  // A cut surface is folded at its concave edge alone, a ball and a cut prism nowhere.
  expectFolded(cut(subdivided(angleBlock(), 2)),
    [](const Vector3& at)
    { return std::abs(at.x() - 8.0) < 1e-5 && std::abs(at.y() - 8.0) < 1e-5; });
  for (const PackedMesh& mesh : { cut(polygonPrism(6, 3)), withCreases(icosphere(10.0, 2), false) })
  {
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangleCount()); ++t)
    {
      EXPECT_FALSE(mesh.isFolded(t)) << t;
    }
  }
}

TEST(CreaseCut, WhatIsNotAskedForIsNotCut)
{
  const Surface body = block(20.0, 15.0, 10.0);
  EXPECT_TRUE(body.packed().creases().empty());
  EXPECT_EQ(body.packed().pointCount(), body.points.size());
}
} // namespace palpate::testing
