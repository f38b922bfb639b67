// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/TriangleTree.h"

#include "BumpySphere.h"
#include "Sanitized.h"
#include "Contact/TriangleBound.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace palpate::testing;
using palpate::PackedMesh;
using palpate::SurfacePoint;
using palpate::TriangleBound;
using palpate::TriangleSearch;
using palpate::TriangleTree;
using palpate::Vector3;

namespace
{
void expectSame(const SurfacePoint& found, const SurfacePoint& expected)
{
  ASSERT_EQ(found.triangle, expected.triangle);
  EXPECT_EQ(found.signedDistance, expected.signedDistance);
  EXPECT_EQ(found.onBorder, expected.onBorder);
  EXPECT_EQ(found.projection.feature, expected.projection.feature);
  EXPECT_EQ(found.projection.point, expected.projection.point);
  EXPECT_EQ(found.projection.weights, expected.projection.weights);
}

/// Compares with the tree for tips that move in small steps, tips that jump, and tips that are
/// equally near to several triangles, to the last bit.
void compareWithTree(const Surface& body, double size, double grid)
{
  const PackedMesh mesh = body.packed();
  const TriangleTree tree(mesh);
  TriangleSearch search(tree);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-0.5, 0.5);
  const auto anyPoint = [&]() { return body.points[random() % body.points.size()]; };
  Vector3 tip = anyPoint();
  for (int i = 0; i < casesOf(20000); ++i)
  {
    const Vector3 step(share(random), share(random), share(random));
    switch (i % 400 == 0 ? 3 : i / casesOf(1000) % 3)
    {
      case 0: // small steps, in and out
        tip += 0.02 * size * step;
        break;
      case 1: // below and above corners and edges
        tip = anyPoint();
        tip[static_cast<Eigen::Index>(random() % 3)] += grid * (static_cast<int>(random() % 9) - 4);
        break;
      case 2: // near the body
        tip = anyPoint() + 0.1 * size * step;
        break;
      default:
        tip = anyPoint() + 3.0 * size * step;
    }
    const Vector3 local = mesh.toLocal(tip);
    expectSame(search.closestLocal(local), tree.closestLocal(local));
    if (::testing::Test::HasFatalFailure())
    {
      return;
    }
  }
}
} // namespace

TEST(TriangleSearch, IsTheTreesToTheBit)
{
  compareWithTree(bumpySphere(40), 200.0, 1.0);
  compareWithTree(torus(20.0, 6.0, 40, 20), 40.0, 0.5);
  compareWithTree(subdivided(block(20, 20, 10), 4), 20.0, 0.3125);
  compareWithTree(subdivided(grooveBlock(), 3), 40.0, 0.625);
  compareWithTree(openPlate(20.0, 32), 20.0, 0.625);
  compareWithTree(block(20, 20, 10), 20.0, 2.5);
}

TEST(TriangleSearch, SurvivesAnyTip)
{
  const PackedMesh mesh = icosphere(20.0, 3).packed();
  const TriangleTree tree(mesh);
  TriangleSearch search(tree);
  const double infinite = std::numeric_limits<double>::infinity();
  const Vector3 inside(0, 0, 19);
  for (const double bad : { std::nan(""), infinite, -infinite, 1e300 })
  {
    expectSame(search.closestLocal(inside), tree.closestLocal(inside));
    expectSame(search.closestLocal({ bad, 0, 0 }), tree.closestLocal({ bad, 0, 0 }));
  }
  const PackedMesh nothing = Surface{}.packed();
  const TriangleTree empty(nothing);
  EXPECT_EQ(TriangleSearch(empty).closestLocal(inside).triangle, -1);
}

/// No bound exceeds the distance by more than its stated tolerance. The bounds are close enough to
/// be useful.
TEST(TriangleBound, IsABound)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<float> share(-1.0F, 1.0F);
  double sum = 0.0;
  double sumOfDistances = 0.0;
  for (int i = 0; i < 100000; ++i)
  {
    // Triangles as large as their distance from the origin, slivers, and tiny triangles.
    const float offset = i % 2 ? 100.0F : 0.0F;
    const float size = std::pow(10.0F, 1.0F + 2.5F * share(random));
    const float thin = i % 5 ? 1.0F : std::pow(10.0F, -3.0F - 3.0F * share(random));
    std::array<float, 9> corners;
    for (std::size_t k = 0; k < 9; ++k)
    {
      corners[k] = offset + size * share(random) * (k % 3 == 1 ? thin : 1.0F);
    }
    const Eigen::Vector3f tip = Eigen::Vector3f::Constant(offset) +
      3.0F * size * Eigen::Vector3f(share(random), share(random), share(random));
    const auto corner = [&](Eigen::Index k)
    { return Eigen::Map<const Eigen::Vector3f>(corners.data() + 3 * k).cast<double>().eval(); };
    const double distance =
      std::sqrt(palpate::projectOnTriangle(tip.cast<double>(), corner(0), corner(1), corner(2))
                  .squaredDistance);
    const float* at = corners.data();
    const TriangleBound::Lane bounds = TriangleBound::squaredDistances(tip, { at, at, at, at });
    const double bound = std::sqrt(static_cast<double>(bounds[i % 4]));
    const double largest = static_cast<double>(tip.cwiseAbs().maxCoeff()) +
      static_cast<double>(Eigen::Map<const Eigen::Array<float, 9, 1>>(at).abs().maxCoeff());
    ASSERT_LE(bound, distance + TriangleBound::Rounding * largest) << i;
    sum += bound;
    sumOfDistances += distance;
  }
  EXPECT_GT(sum, 0.7 * sumOfDistances);
}
