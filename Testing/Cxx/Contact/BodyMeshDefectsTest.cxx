// SPDX-License-Identifier: BSD-3-Clause
// Defects of a mesh are counted and left out. Also borders and the enclosed volume.
#include "BruteForce.h"
#include "Contact/TriangleTree.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

using namespace palpate::testing;
using palpate::BodyMesh;
using palpate::NotANumber;
using palpate::PackedMesh;
using palpate::TriangleTree;
using palpate::Vector3;

TEST(BodyMeshDefects, SoundBodiesHaveNone)
{
  for (const Surface& body :
    { icosphere(20.0, 2), torus(20.0, 6.0, 12, 8), angleBlock(), grooveBlock() })
  {
    const BodyMesh mesh = body.mesh();
    EXPECT_TRUE(mesh.isClosed());
    EXPECT_EQ(mesh.defects().degenerate + mesh.defects().notFinite + mesh.defects().badIndex +
        mesh.defects().nonManifoldEdges + mesh.defects().borderEdges,
      0u);
  }
}

TEST(BodyMeshDefects, Volume)
{
  // Products of small integers are exact; the sum has a few roundings.
  EXPECT_NEAR(block(3, 4, 5).mesh().enclosedVolume(), 60.0, 1e-12);
  EXPECT_NEAR(angleBlock().mesh().enclosedVolume(), (20 * 20 - 12 * 12) * 10.0, 1e-10);
  EXPECT_NEAR(grooveBlock().mesh().enclosedVolume(), (40 * 10 - 25) * 40.0, 1e-9);
  Surface inverted = block(3, 4, 5);
  for (auto& t : inverted.triangles)
  {
    std::swap(t[0], t[1]);
  }
  EXPECT_NEAR(inverted.mesh().enclosedVolume(), -60.0, 1e-12);
  EXPECT_TRUE(inverted.mesh().isClosed());
  Surface far = block(3, 4, 5);
  for (Vector3& p : far.points)
  {
    p += Vector3(1e6, -1e6, 1e6);
  }
  EXPECT_NEAR(far.mesh().enclosedVolume(), 60.0, 1e-7); // rounding of the coordinates: 1e-10
}

TEST(BodyMeshDefects, EmptyBodies)
{
  for (const BodyMesh& mesh :
    { BodyMesh(nullptr, 0, nullptr, 0), Surface{ { { 1, 2, 3 } }, {} }.mesh() })
  {
    EXPECT_FALSE(mesh.isClosed());
    EXPECT_EQ(mesh.enclosedVolume(), 0.0);
    const PackedMesh packed(
      mesh.coordinates(), mesh.pointCount(), mesh.indices(), mesh.triangleCount());
    EXPECT_EQ(TriangleTree(packed).closest(Vector3::Zero()).triangle, -1);
  }
}

TEST(BodyMeshDefects, CountedAndLeftOut)
{
  Surface body = block(10, 10, 10);
  const auto sound = static_cast<std::int32_t>(body.triangles.size());
  body.points.emplace_back(NotANumber, 0.0, 0.0);
  body.points.emplace_back(0.0, std::numeric_limits<double>::infinity(), 0.0);
  body.points.emplace_back(-5.0, -5.0, -5.0);
  body.points.emplace_back(-6.0, -6.0, -6.0);
  body.points.emplace_back(-7.0, -7.0, -7.0);
  const auto n = static_cast<std::int32_t>(body.points.size());
  body.triangles.push_back({ 0, 1, n - 5 });         // a point that is NaN
  body.triangles.push_back({ 0, n - 4, 1 });         // a point that is infinite
  body.triangles.push_back({ 0, 1, n });             // an index out of range
  body.triangles.push_back({ -1, 0, 1 });            // an index out of range
  body.triangles.push_back({ n + 100000, 0, 1 });    // an index far out of range
  body.triangles.push_back({ n - 3, n - 3, 1 });     // a corner twice
  body.triangles.push_back({ n - 3, n - 2, n - 1 }); // three corners on one line
  const BodyMesh mesh = body.mesh();
  EXPECT_EQ(mesh.defects().notFinite, 2u);
  EXPECT_EQ(mesh.defects().badIndex, 3u);
  EXPECT_EQ(mesh.defects().degenerate, 2u);
  EXPECT_EQ(mesh.defects().borderEdges, 0u); // the block itself is closed
  EXPECT_EQ(mesh.defects().nonManifoldEdges, 0u);
  EXPECT_FALSE(mesh.isClosed());
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(body.triangles.size()); ++t)
  {
    EXPECT_EQ(mesh.isUsable(t), t < sound) << t;
  }
  EXPECT_NEAR(mesh.enclosedVolume(), 1000.0, 1e-10);
  EXPECT_EQ(mesh.pointNormal(n - 3), Vector3::Zero()); // no usable triangle contains the point
  // The closest points are on the block, not on the broken triangles next to it.
  const PackedMesh packed = body.packed();
  EXPECT_EQ(packed.defects().notFinite, 2u);
  EXPECT_EQ(packed.defects().badIndex, 3u);
  EXPECT_EQ(packed.defects().degenerate, 2u);
  EXPECT_EQ(packed.defects().borderEdges + packed.defects().nonManifoldEdges, 0u);
  EXPECT_EQ(packed.triangleCount(), static_cast<std::size_t>(sound));
  const TriangleTree tree(packed);
  const auto found = tree.closest(Vector3(-6, -6, -6));
  EXPECT_EQ(found.projection.point, Vector3::Zero());
  EXPECT_LT(packed.inputTriangle(found.triangle), sound);
}

TEST(BodyMeshDefects, BorderOfAnOpenPlate)
{
  const Surface body = openPlate(10.0, 5);
  const BodyMesh mesh = body.mesh();
  EXPECT_EQ(mesh.defects().borderEdges, 20u);
  EXPECT_EQ(mesh.defects().nonManifoldEdges, 0u);
  EXPECT_FALSE(mesh.isClosed());
  const PackedMesh packed = body.packed();
  EXPECT_EQ(packed.defects().borderEdges, 20u);
  const TriangleTree tree(packed);
  EXPECT_TRUE(tree.closest(Vector3(-1, 5.3, -1)).onBorder);   // on an edge of the border
  EXPECT_TRUE(tree.closest(Vector3(-1, -1, -1)).onBorder);    // at a corner of the border
  EXPECT_TRUE(tree.closest(Vector3(-1, 4.0, -1)).onBorder);   // at a point of the border
  EXPECT_FALSE(tree.closest(Vector3(5.1, 5.3, -1)).onBorder); // on a face
  EXPECT_FALSE(tree.closest(Vector3(4.0, 4.0, -1)).onBorder); // at an inner point
  EXPECT_EQ(tree.closest(Vector3(5.1, 5.3, -1)).signedDistance, -1.0);
  EXPECT_EQ(tree.closest(Vector3(5.1, 5.3, 2)).signedDistance, 2.0);
}

TEST(BodyMeshDefects, NonManifoldEdges)
{
  // Three triangles at one edge.
  Surface fins;
  fins.points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, -1, 0 } };
  fins.triangles = { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } };
  const BodyMesh finsMesh = fins.mesh();
  EXPECT_EQ(finsMesh.defects().nonManifoldEdges, 1u);
  EXPECT_EQ(finsMesh.defects().borderEdges, 6u);
  EXPECT_FALSE(finsMesh.isClosed());
  // An edge of three triangles has no neighbour across it and counts as border.
  const PackedMesh packedFins = fins.packed();
  EXPECT_EQ(packedFins.defects().nonManifoldEdges, 1u);
  EXPECT_TRUE(TriangleTree(packedFins).closest(Vector3(0.0, 0.0, 0.5)).onBorder);

  // Two neighbours with opposite winding.
  Surface flipped;
  flipped.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 } };
  flipped.triangles = { { 0, 1, 2 }, { 0, 1, 3 } };
  EXPECT_EQ(flipped.mesh().defects().nonManifoldEdges, 1u);
  EXPECT_EQ(flipped.mesh().defects().borderEdges, 4u);

  // The same triangle twice.
  Surface twice;
  twice.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  twice.triangles = { { 0, 1, 2 }, { 0, 1, 2 } };
  EXPECT_EQ(twice.mesh().defects().nonManifoldEdges, 3u);
}

TEST(BodyMeshDefects, TwoBodiesThatShareAPointAreClosed)
{
  // Two tetrahedra that touch at one point. Each edge has two triangles, but the triangles around
  // the common point are two separate fans.
  Surface body;
  body.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { -1, 0, 0 }, { 0, -1, 0 },
    { 0, 0, -1 } };
  body.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 }, { 0, 4, 5 }, { 0, 6, 4 },
    { 0, 5, 6 }, { 4, 6, 5 } };
  EXPECT_TRUE(body.mesh().isClosed());
  EXPECT_NEAR(body.mesh().enclosedVolume(), 1.0 / 3.0, 1e-15);
}

TEST(BodyMeshDefects, PointNormalsAreAngleWeighted)
{
  // Three right angles meet at a corner of a block. The normal does not depend on the diagonals of
  // the faces.
  const Surface body = block(2, 3, 4);
  const BodyMesh mesh = body.mesh();
  for (std::size_t i = 0; i < body.points.size(); ++i)
  {
    Vector3 expected = body.points[i] - Vector3(1, 1.5, 2);
    expected = expected.cwiseSign() / std::sqrt(3.0);
    EXPECT_LE((mesh.pointNormal(static_cast<std::int32_t>(i)) - expected).norm(), 1e-15);
  }
}
