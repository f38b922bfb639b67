// SPDX-License-Identifier: BSD-3-Clause
// Inside or outside, by the pseudonormal of the closest feature, against independent tests.
#include "BruteForce.h"
#include "Contact/TriangleTree.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

using namespace palpate::testing;
using palpate::SurfacePoint;
using palpate::TriangleTree;
using palpate::Vector3;

namespace
{
Vector3 randomIn(std::mt19937& random, const Vector3& low, const Vector3& high)
{
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Vector3 p;
  for (int k = 0; k < 3; ++k)
  {
    p[k] = low[k] + share(random) * (high[k] - low[k]);
  }
  return p;
}

/// Compares with `side`, which returns > 0 inside, < 0 outside, and 0 if unknown.
void compareSides(const Surface& body, const Vector3& low, const Vector3& high, int tips,
  const std::function<int(const Vector3&)>& side)
{
  const palpate::PackedMesh mesh = body.packed();
  ASSERT_EQ(mesh.defects().borderEdges, 0u);
  const TriangleTree tree(mesh);
  std::mt19937 random(5);
  int inside = 0;
  int outside = 0;
  for (int i = 0; i < tips; ++i)
  {
    const Vector3 tip = randomIn(random, low, high);
    const SurfacePoint found = tree.closest(tip);
    const int expected = side(tip);
    if (expected != 0)
    {
      EXPECT_EQ(found.signedDistance<0.0, expected> 0) << tip.transpose();
      EXPECT_FALSE(found.onBorder);
      ++(expected > 0 ? inside : outside);
    }
  }
  EXPECT_GT(inside, tips / 10);
  EXPECT_GT(outside, tips / 10);
}

std::function<int(const Vector3&)> byWinding(const Surface& body)
{
  return [&body](const Vector3& tip)
  {
    const double winding = windingNumber(body, tip);
    return winding > 0.9 ? 1 : winding < 0.1 ? -1 : 0;
  };
}
} // namespace

TEST(PackedMeshSide, Icosphere)
{
  const double R = 20.0;
  const Surface body = icosphere(R, 2).rounded();
  // The facets are at most their sagitta inside the sphere: h²/8R = 0.6 for h <= 10.
  compareSides(body, Vector3::Constant(-25.0), Vector3::Constant(25.0), 20000,
    [&](const Vector3& tip) { return tip.norm() > R    ? -1
                                : tip.norm() < R - 0.7 ? 1
                                                       : 0; });
  compareSides(body, Vector3::Constant(-20.0), Vector3::Constant(20.0), 2000, byWinding(body));
}

TEST(PackedMeshSide, Torus)
{
  const Surface body = torus(20.0, 6.0, 48, 24).rounded();
  // Chords are within r(1-cos(π/24)) + (R+r)(1-cos(π/48)) = 0.11 of the torus.
  compareSides(body, Vector3(-28, -28, -8), Vector3(28, 28, 8), 20000,
    [](const Vector3& tip)
    {
      const double radius = std::hypot(std::hypot(tip.x(), tip.y()) - 20.0, tip.z());
      return radius > 6.12 ? -1 : radius < 5.88 ? 1 : 0;
    });
  compareSides(body, Vector3(-28, -28, -8), Vector3(28, 28, 8), 1000, byWinding(body));
}

TEST(PackedMeshSide, AngleBlock)
{
  // Coarse and fine: on the coarse body almost every closest feature is an edge or a corner.
  for (const int times : { 0, 2 })
  {
    const Surface body = subdivided(angleBlock(), times);
    compareSides(body, Vector3::Constant(-5.0), Vector3(25, 25, 15), 20000,
      [](const Vector3& tip)
      {
        const bool inside = tip.minCoeff() > 0.0 && tip.z() < 10.0 && tip.x() < 20.0 &&
          tip.y() < 20.0 && (tip.x() < 8.0 || tip.y() < 8.0);
        return inside ? 1 : -1;
      });
  }
}

TEST(PackedMeshSide, GrooveBlock)
{
  const Surface body = grooveBlock();
  compareSides(body, Vector3(-25, -3, -5), Vector3(25, 13, 45), 20000,
    [](const Vector3& tip)
    {
      const bool inside = std::abs(tip.x()) < 20.0 && tip.y() > 0.0 && tip.y() < 10.0 &&
        tip.z() > 0.0 && tip.z() < 40.0 && tip.y() < 5.0 + std::abs(tip.x());
      return inside ? 1 : -1;
    });
}

namespace
{
/// Compares tips at a distance of 1e-6 from every point and from the middle of every edge, in
/// random directions.
void compareNextToEdgesAndCorners(const Surface& given)
{
  const Surface body = given.rounded();
  const palpate::PackedMesh mesh = body.packed();
  const TriangleTree tree(mesh);
  std::mt19937 random(6);
  const auto check = [&](const Vector3& near)
  {
    for (int i = 0; i < 50; ++i)
    {
      const Vector3 tip =
        near + randomIn(random, Vector3::Constant(-1e-6), Vector3::Constant(1e-6));
      const double winding = windingNumber(body, tip);
      if (std::abs(winding - 0.5) > 0.4)
      {
        const bool inside = winding > 0.5;
        EXPECT_EQ(tree.closest(tip).signedDistance < 0.0, inside) << tip.transpose();
      }
    }
  };
  for (const Vector3& p : body.points)
  {
    check(p);
  }
  for (const std::int32_t t : allTriangles(body))
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      check(0.5 * (body.corner(t, k) + body.corner(t, (k + 1) % 3)));
    }
  }
}
} // namespace

TEST(PackedMeshSide, RightNextToEdgesAndCorners)
{
  compareNextToEdgesAndCorners(angleBlock());
  compareNextToEdgesAndCorners(grooveBlock());
}

TEST(PackedMeshSide, RightNextToAKnifeEdge)
{
  // A body with an edge of 11°, and a body with a notch of this angle. Near such an edge the normal
  // of one face alone is wrong for most tips.
  compareNextToEdgesAndCorners(prism({ { 0, 0 }, { 20, 0 }, { 20, 4 } }, { { 0, 1, 2 } }, 10.0));
  compareNextToEdgesAndCorners(
    prism({ { -10, -10 }, { 20, -10 }, { 20, 0 }, { 0, 0 }, { 20, 4 }, { 20, 14 }, { -10, 14 } },
      { { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 6 }, { 3, 4, 6 }, { 4, 5, 6 } }, 10.0));
}
