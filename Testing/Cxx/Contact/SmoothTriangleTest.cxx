// SPDX-License-Identifier: BSD-3-Clause
// One patch: the values that it interpolates, the values in common with its neighbour, and its
// distance from a sphere.
#include "Contact/SmoothTriangle.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <random>
#include <vector>

using palpate::SmoothTriangle;
using palpate::SurfaceJet;
using palpate::Vector3;

namespace
{
using Three = std::array<Vector3, 3>;

class Chance
{
public:
  explicit Chance(unsigned seed)
    : Source(seed)
  {
  }
  double share() { return this->Uniform(this->Source); }
  Vector3 vector()
  {
    const double x = this->Gauss(this->Source);
    const double y = this->Gauss(this->Source);
    return { x, y, this->Gauss(this->Source) };
  }
  Vector3 weights()
  {
    const double a = std::sqrt(this->share());
    const double b = this->share();
    return { 1.0 - a, a * (1.0 - b), a * b };
  }

private:
  std::mt19937 Source;
  std::uniform_real_distribution<double> Uniform{ 0.0, 1.0 };
  std::normal_distribution<double> Gauss;
};

Vector3 facetNormal(const Three& p)
{
  return (p[1] - p[0]).cross(p[2] - p[0]).normalized();
}

/// Two triangles abc and bad of any shape. Their normals differ by about 20° from those of the
/// facets.
struct Pair
{
  Three first, second;
  Three firstNormals, secondNormals;
};

Pair anyPair(Chance& chance)
{
  const Vector3 a = chance.vector();
  const Vector3 b = chance.vector();
  const Vector3 c = chance.vector();
  const Vector3 d = a + b - c + 0.3 * (b - a).norm() * chance.vector();
  Pair pair{ { a, b, c }, { b, a, d }, {}, {} };
  const Vector3 here = facetNormal(pair.first);
  const Vector3 there = facetNormal(pair.second);
  const auto bent = [&](const Vector3& n)
  { return Vector3((n.normalized() + 0.2 * chance.vector()).normalized()); };
  const Vector3 na = bent(here + there);
  const Vector3 nb = bent(here + there);
  pair.firstNormals = { na, nb, bent(here) };
  pair.secondNormals = { nb, na, bent(there) };
  return pair;
}

double greatest(const SurfaceJet& a, const SurfaceJet& b)
{
  return std::max({ (a.point - b.point).norm(), (a.dv - b.dv).norm(), (a.dw - b.dw).norm(),
    (a.dvv - b.dvv).norm(), (a.dvw - b.dvw).norm(), (a.dww - b.dww).norm() });
}
} // namespace

TEST(SmoothTriangle, FlatDataGiveTheFlatTriangle)
{
  Chance chance(1);
  for (int i = 0; i < 100; ++i)
  {
    const Three p = { chance.vector(), chance.vector(), chance.vector() };
    const Vector3 n = 3.0 * facetNormal(p); // not necessarily of unit length
    SmoothTriangle patch;
    ASSERT_TRUE(patch.build(p, { n, n, n }));
    const Vector3 u = chance.weights();
    SurfaceJet flat;
    flat.point = u[0] * p[0] + u[1] * p[1] + u[2] * p[2];
    flat.dv = p[1] - p[0];
    flat.dw = p[2] - p[0];
    // Rounding of 12 differences of control points; depends on the shape of the triangle.
    EXPECT_LE(greatest(patch.evaluate(u), flat), 1e-11);
  }
}

TEST(SmoothTriangle, PassesThroughCornersPerpendicularToTheirNormals)
{
  Chance chance(2);
  int built = 0;
  for (int i = 0; i < 300; ++i)
  {
    const Pair pair = anyPair(chance);
    SmoothTriangle patch;
    if (!patch.build(pair.first, pair.firstNormals))
    {
      continue;
    }
    ++built;
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      const auto at = static_cast<std::size_t>(k);
      const SurfaceJet jet = patch.evaluate(Vector3::Unit(k));
      EXPECT_LE((jet.point - pair.first[at]).norm(), 1e-14);
      EXPECT_LE((jet.across().normalized() - pair.firstNormals[at]).norm(), 1e-10);
    }
  }
  EXPECT_GT(built, 150);
}

TEST(SmoothTriangle, NeighboursShareCurveAndTangentPlanes)
{
  Chance chance(3);
  int built = 0;
  for (int i = 0; i < 500; ++i)
  {
    const Pair pair = anyPair(chance);
    SmoothTriangle first;
    SmoothTriangle second;
    if (!first.build(pair.first, pair.firstNormals) ||
      !second.build(pair.second, pair.secondNormals))
    {
      continue;
    }
    ++built;
    for (int k = 1; k < 20; ++k)
    {
      const double t = k / 20.0;
      const SurfaceJet here = first.evaluate({ 1.0 - t, t, 0.0 });
      const SurfaceJet there = second.evaluate({ t, 1.0 - t, 0.0 });
      EXPECT_LE((here.point - there.point).norm(), 1e-14);
      const Vector3 n = here.across().normalized();
      // Rounding divided by the angle between the derivatives, which may be small for random
      // corners.
      EXPECT_LE(n.cross(there.across().normalized()).norm(), 1e-11);
      EXPECT_GT(n.dot(there.across()), 0.0);
    }
  }
  EXPECT_GT(built, 150);
}

TEST(SmoothTriangle, DerivativesAreThoseOfThePoints)
{
  Chance chance(4);
  const double e = 1e-4;
  int built = 0;
  for (int i = 0; i < 300; ++i)
  {
    const Pair pair = anyPair(chance);
    const Vector3 u = chance.weights();
    SmoothTriangle patch;
    if (u.minCoeff() < 0.05 || !patch.build(pair.first, pair.firstNormals))
    {
      continue;
    }
    ++built;
    const auto at = [&](double v, double w) {
      return patch.evaluate({ u[0] - v - w, u[1] + v, u[2] + w }).point;
    };
    const Vector3 o = at(0, 0);
    SurfaceJet differences;
    differences.point = o;
    differences.dv = (at(e, 0) - at(-e, 0)) / (2 * e);
    differences.dw = (at(0, e) - at(0, -e)) / (2 * e);
    differences.dvv = (at(e, 0) - 2 * o + at(-e, 0)) / (e * e);
    differences.dww = (at(0, e) - 2 * o + at(0, -e)) / (e * e);
    differences.dvw = (at(e, e) - at(e, -e) - at(-e, e) + at(-e, -e)) / (4 * e * e);
    // e² times a fourth derivative (24 control points of order 1, and more from Gregory's terms
    // near corners), plus rounding / e²: 1e-7 each.
    EXPECT_LE(greatest(patch.evaluate(u), differences), 1e-5);
  }
  EXPECT_GT(built, 50);
}

TEST(SmoothTriangle, ComesToASphereWithTheFourthPowerOfItsSize)
{
  const double R = 20.0;
  std::vector<double> faces;
  std::vector<double> edges;
  std::vector<double> normals;
  for (const double size : { 8.0, 4.0, 2.0, 1.0 })
  {
    Chance chance(5); // gives the same shapes for each size
    double face = 0.0;
    double edge = 0.0;
    double turned = 0.0;
    for (int i = 0; i < 400; ++i)
    {
      const Vector3 middle = chance.vector().normalized();
      const Vector3 x = middle.unitOrthogonal();
      const Vector3 y = middle.cross(x);
      Three p;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const double angle = 2.1 * static_cast<double>(k) + 0.4 * chance.share();
        const double r = size / std::sqrt(3.0) / R * (0.8 + 0.4 * chance.share());
        p[k] = R * (middle + r * (std::cos(angle) * x + std::sin(angle) * y)).normalized();
      }
      SmoothTriangle patch;
      ASSERT_TRUE(patch.build(p, p)); // normals are not necessarily of unit length
      const SurfaceJet inside = patch.evaluate(chance.weights());
      const double t = chance.share();
      face = std::max(face, std::abs(inside.point.norm() - R));
      turned =
        std::max(turned, inside.across().normalized().cross(inside.point.normalized()).norm());
      edge = std::max(edge, std::abs(patch.evaluate({ 1.0 - t, t, 0.0 }).point.norm() - R));
    }
    faces.push_back(face);
    edges.push_back(edge);
    normals.push_back(turned);
    // The facet is size²/6R inside the sphere (equilateral, circumradius size/√3).
    EXPECT_LT(face, 0.01 * size * size / (6.0 * R));
  }
  // The errors have orders 4, 6 and 3: half the size divides them by 16, 64 and 8. The test
  // requires half of these factors, since the coarsest shapes are a third of the radius wide.
  for (std::size_t i = 1; i < faces.size(); ++i)
  {
    EXPECT_LT(faces[i], faces[i - 1] / 8.0);
    EXPECT_LT(normals[i], normals[i - 1] / 4.0);
  }
  EXPECT_LT(edges[1], edges[0] / 32.0);
  EXPECT_LT(edges[2], edges[1] / 32.0); // the finest size is at rounding level
}

// Vectors of four numbers, of 32 bytes, are read from members that are aligned for two numbers.
TEST(SmoothTriangle, AtEveryAddress)
{
  Chance chance(5);
  const Pair pair = anyPair(chance);
  const Vector3 weights = chance.weights();
  SmoothTriangle here;
  ASSERT_TRUE(here.build(pair.first, pair.firstNormals));
  const Vector3 point = here.evaluate(weights).point;
  for (std::size_t offset = 0; offset < 64; offset += alignof(SmoothTriangle))
  {
    alignas(64) std::array<std::byte, sizeof(SmoothTriangle) + 64> memory;
    auto* const there = new (memory.data() + offset) SmoothTriangle(here);
    EXPECT_EQ(there->evaluate(weights).point, point) << offset;
  }
}

TEST(SmoothTriangle, RefusesWhatHasNoSmoothSurface)
{
  const Three p = { Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0) };
  const Vector3 up(0, 0, 1);
  SmoothTriangle patch;
  EXPECT_TRUE(patch.build(p, { up, up, up }));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto leaning = [](double cosine)
  { return Vector3(std::sqrt(1.0 - cosine * cosine), 0.0, cosine); };
  EXPECT_TRUE(patch.build(p, { up, leaning(SmoothTriangle::SmallestCosine + 0.01), up }));
  for (const Vector3& bad : { Vector3(Vector3::Zero()), Vector3(0, 0, nan), Vector3(-up),
         leaning(SmoothTriangle::SmallestCosine - 0.01) })
  {
    EXPECT_FALSE(patch.build(p, { bad, up, up }));
    EXPECT_FALSE(patch.build(p, { up, bad, up }));
    EXPECT_FALSE(patch.build(p, { up, up, bad }));
  }
  EXPECT_FALSE(patch.build({ p[0], p[1], p[1] }, { up, up, up })); // a triangle without area
  EXPECT_FALSE(patch.build({ p[0], p[0], p[0] }, { up, up, up }));
  EXPECT_FALSE(patch.build({ p[0], p[1], Vector3(0, nan, 0) }, { up, up, up }));
}
