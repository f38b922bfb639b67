// SPDX-License-Identifier: BSD-3-Clause
// If isCertainlyNearest() returns true, no triangle with a common corner is nearer: on bodies that
// are bumpy, convex, saddle-shaped, notched, sharp and crumpled.
#include "BruteForce.h"
#include "BumpySphere.h"
#include "Sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace palpate::testing
{
namespace
{
/// A ball with points moved at random, which has spikes, pits, and folds up to and beyond a right
/// angle.
Surface crumpledBall(double roughness, unsigned seed)
{
  Surface body = icosphere(20.0, 3);
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss(0.0, roughness);
  for (Vector3& p : body.points)
  {
    p += Vector3(gauss(random), gauss(random), gauss(random));
  }
  return body;
}

struct Counts
{
  int certified = 0;
  int wronglyCertified = 0;
  int nearerAround = 0; ///< number of tips that are nearer to a triangle around
};

/// Counts tips below random points of random faces, at depths from a thousandth of `deepest` to
/// `deepest`.
Counts countCertificates(const Surface& given, double deepest, int tips)
{
  const Surface body = given.rounded();
  const PackedMesh mesh = body.packed();
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Counts counts;
  for (int i = 0; i < tips; ++i)
  {
    const auto triangle = static_cast<std::int32_t>(random() % mesh.triangleCount());
    const double u = std::sqrt(share(random));
    const double v = u * share(random);
    const Vector3 foot = (1.0 - u) * mesh.corner(triangle, 0) + (u - v) * mesh.corner(triangle, 1) +
      v * mesh.corner(triangle, 2);
    const double depth = deepest * std::pow(10.0, -3.0 * share(random));
    const Vector3 tip = foot - depth * mesh.faceNormal(triangle);
    const TriangleProjection projection = mesh.project(tip, triangle);
    if (projection.feature != TriangleFeature::Face)
    {
      continue; // the projection is at the rim of the face because of rounding
    }
    std::vector<std::int32_t> around;
    for (const std::int32_t corner : mesh.corners(triangle))
    {
      mesh.visitAround(
        corner, [&](std::int32_t other) { around.push_back(mesh.inputTriangle(other)); });
    }
    const Nearest nearest = nearestOf(body, mesh.centre() + tip, around);
    // 1e-12 of the diagonal: rounding of the coordinates.
    const bool isNearer =
      nearest.distance < std::sqrt(projection.squaredDistance) - 1e-12 * diagonal(body);
    const bool certified = mesh.isCertainlyNearest(tip, triangle, projection);
    counts.certified += certified;
    counts.nearerAround += isNearer;
    counts.wronglyCertified += certified && isNearer;
  }
  return counts;
}
} // namespace

TEST(PackedMeshCertificate, IsNeverWrong)
{
  const Surface knife = prism({ { 0, 0 }, { 20, 0 }, { 20, 4 } }, { { 0, 1, 2 } }, 10.0);
  int certified = 0;
  int nearerAround = 0;
  for (const auto& [body, deepest] :
    std::initializer_list<std::pair<Surface, double>>{ { bumpySphere(20), 10.0 },
      { bumpySphere(60), 30.0 }, { icosphere(20.0, 2), 19.0 }, { torus(20.0, 6.0, 40, 20), 5.9 },
      { torus(20.0, 6.0, 12, 8), 5.9 }, { subdivided(angleBlock(), 2), 8.0 },
      { grooveBlock(), 8.0 }, { subdivided(grooveBlock(), 2), 8.0 }, { knife, 4.0 },
      { subdivided(knife, 3), 4.0 }, { crumpledBall(0.1, 1), 5.0 }, { crumpledBall(0.5, 2), 5.0 },
      { crumpledBall(2.0, 3), 5.0 } })
  {
    const Counts counts = countCertificates(body, deepest, casesOf(3000));
    EXPECT_EQ(counts.wronglyCertified, 0);
    certified += counts.certified;
    nearerAround += counts.nearerAround;
  }
  // The test needs enough cases: of 39000 tips, thousands are of either kind.
  EXPECT_GT(certified, casesOf(5000));
  EXPECT_GT(nearerAround, casesOf(3000));
}

TEST(PackedMeshCertificate, WhereAllNeighboursRiseItNeedsNoMargin)
{
  // No surface is below a face of a flat top, so the smallest margin is enough at any depth.
  const PackedMesh mesh = openPlate(10.0, 4).packed();
  for (const double depth : { 1e-6, 1.0, 1e6 })
  {
    const Vector3 tip(0.3, 0.2, -depth);
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangleCount()); ++t)
    {
      const TriangleProjection projection = mesh.project(tip, t);
      if (projection.feature == TriangleFeature::Face)
      {
        EXPECT_TRUE(mesh.isCertainlyNearest(tip, t, projection)) << depth;
      }
    }
  }
}

TEST(PackedMeshCertificate, MarginOfAConvexEdge)
{
  // Two facets that meet at a right angle: the other facet is nearer if the distance m of the foot
  // from the edge is less than the depth d of the tip. Every corner of this block has a face at a
  // right angle, whose slope relative to the first face is unbounded, so the result is never
  // certain, for any distance of the edge.
  const PackedMesh box = block(40, 40, 40).packed();
  const Vector3 tip(0.0, 1.0, 19.9);
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(box.triangleCount()); ++t)
  {
    const TriangleProjection projection = box.project(tip, t);
    EXPECT_FALSE(box.isCertainlyNearest(tip, t, projection));
  }
  // A roof with a slope of 1 : 10 on either side: b = 2·0.1/(1 - 0.01) is the tangent of the angle
  // between its sides. The result is certain from m = d b/2 on.
  Surface roof;
  roof.points = { { 0, -10, 0 }, { 0, 10, 0 }, { 10, 0, -1 }, { -10, 0, -1 } };
  roof.triangles = { { 1, 0, 2 }, { 0, 1, 3 } };
  const PackedMesh mesh = roof.packed();
  const double bend = 0.2 / (1.0 - 0.01);
  for (const double depth : { 0.5, 1.0, 4.0 })
  {
    for (const double margin : { 0.99, 1.01 })
    {
      const double m = margin * depth * bend / 2.0;
      const Vector3 down = Vector3(1, 0, -0.1).normalized();
      const Vector3 normal = Vector3(0.1, 0, 1).normalized();
      const Vector3 tipUnder = mesh.toLocal(m * down - depth * normal);
      const std::int32_t side = mesh.inputTriangle(0) == 0 ? 0 : 1;
      const TriangleProjection projection = mesh.project(tipUnder, side);
      ASSERT_EQ(projection.feature, TriangleFeature::Face);
      EXPECT_EQ(mesh.isCertainlyNearest(tipUnder, side, projection), margin > 1.0) << depth;
    }
  }
}

TEST(PackedMeshCertificate, ATipOutsideIsNever)
{
  const PackedMesh mesh = openPlate(10.0, 4).packed();
  const Vector3 tip(0.3, 0.2, 1.0);
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangleCount()); ++t)
  {
    EXPECT_FALSE(mesh.isCertainlyNearest(tip, t, mesh.project(tip, t)));
  }
}
} // namespace palpate::testing
