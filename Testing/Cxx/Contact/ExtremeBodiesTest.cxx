// SPDX-License-Identifier: BSD-3-Clause
// Contact on extreme bodies: one triangle, a hundred thousand parts, a position a kilometre from
// the origin.
#include "BruteForce.h"
#include "Contact/ContactBody.h"
#include "SampleResponses.h"
#include "Contact/ToolContact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace palpate::testing
{
namespace
{
/// F = 10 δ^1.5 (N, mm), as in uniformBody().
double law(double depth)
{
  return 10.0 * std::pow(depth, 1.5);
}

/// `side`³ tetrahedra of 4 to 8 mm with random rotation and size, each centred at a point of a
/// lattice of 12 mm. No two of them touch.
constexpr double Lattice = 12.0;
Surface scatteredTetrahedra(int side, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Surface body;
  for (int cell = 0; cell < side * side * side; ++cell)
  {
    const Vector3 centre(cell % side, cell / side % side, cell / (side * side));
    const Vector3 axis(uniform(random), uniform(random), uniform(random));
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(3.0 * uniform(random), (axis + Vector3(2.0, 0.0, 0.0)).normalized())
        .toRotationMatrix();
    const double size = 3.0 + uniform(random);
    const auto first = static_cast<std::int32_t>(body.points.size());
    for (const Vector3& corner : { Vector3(1.0, 1.0, 1.0), Vector3(1.0, -1.0, -1.0),
           Vector3(-1.0, 1.0, -1.0), Vector3(-1.0, -1.0, 1.0) })
    {
      body.points.emplace_back(Lattice * centre + turn * (size / std::sqrt(3.0) * corner));
    }
    for (const auto& [a, b, c] : { std::array{ 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } })
    {
      const std::array<Vector3, 3> p = { body.points[static_cast<std::size_t>(first + a)],
        body.points[static_cast<std::size_t>(first + b)],
        body.points[static_cast<std::size_t>(first + c)] };
      const bool outward = (p[1] - p[0]).cross(p[2] - p[0]).dot(p[0] - Lattice * centre) > 0.0;
      body.triangles.push_back(outward ? std::array{ first + a, first + b, first + c }
                                       : std::array{ first + a, first + c, first + b });
    }
  }
  return body;
}

/// The triangles of the tetrahedra around a tip's lattice cell. All other triangles are farther
/// away.
std::vector<std::int32_t> trianglesNear(const Vector3& tip, int side)
{
  std::vector<std::int32_t> near;
  const Eigen::Vector3i at = (tip / Lattice).array().round().cast<int>();
  for (int cell = 0; cell < 27; ++cell)
  {
    const Eigen::Vector3i there =
      at + Eigen::Vector3i(cell % 3 - 1, cell / 3 % 3 - 1, cell / 9 - 1);
    if (there.minCoeff() >= 0 && there.maxCoeff() < side)
    {
      const std::int32_t piece = (there[2] * side + there[1]) * side + there[0];
      for (std::int32_t t = 4 * piece; t < 4 * piece + 4; ++t)
      {
        near.push_back(t);
      }
    }
  }
  return near;
}

/// True if the tip is inside all four faces of a tetrahedron.
bool isInside(const Surface& body, std::int32_t piece, const Vector3& tip)
{
  for (std::int32_t t = 4 * piece; t < 4 * piece + 4; ++t)
  {
    const Vector3 a = body.corner(t, 0);
    const Vector3 normal = (body.corner(t, 1) - a).cross(body.corner(t, 2) - a);
    if (normal.dot(tip - a) > 0.0)
    {
      return false;
    }
  }
  return true;
}

Surface moved(Surface body, const Vector3& by)
{
  for (Vector3& point : body.points)
  {
    point += by;
  }
  return body;
}

/// Tips 0.2 to 2 mm below a sphere of 20 mm.
std::vector<Vector3> tipsUnderSphere(int count)
{
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> depth(0.2, 2.0);
  std::vector<Vector3> tips;
  for (int i = 0; i < count; ++i)
  {
    const double x = normal(random);
    const double y = normal(random);
    const Vector3 direction = Vector3(x, y, normal(random)).normalized();
    tips.emplace_back((20.0 - depth(random)) * direction);
  }
  return tips;
}

/// Largest differences between contacts on a distant body and on the same body at the origin.
struct FarError
{
  double depth = 0.0; ///< mm
  double force = 0.0; ///< relative, for tips at a depth of at least 1 mm
};

FarError farError(const Surface& near, const Surface& far, const Vector3& away)
{
  const auto nearBody = uniformBody(near);
  const auto farBody = uniformBody(far);
  ToolContact here(*nearBody);
  ToolContact there(*farBody);
  FarError worst;
  for (const Vector3& tip : tipsUnderSphere(500))
  {
    here.reset();
    there.reset();
    const Contact expected = here.update(tip);
    const Contact found = there.update(tip + away);
    EXPECT_EQ(found.state, expected.state);
    worst.depth = std::max(worst.depth, std::abs(found.deflection - expected.deflection));
    if (expected.deflection > 1.0)
    {
      worst.force = std::max(worst.force, std::abs(found.normalForce / expected.normalForce - 1.0));
    }
  }
  return worst;
}
} // namespace

TEST(ExtremeBodies, OneTriangle)
{
  Surface body;
  body.points = { { 0.0, 0.0, 0.0 }, { 8.0, 0.0, 0.0 }, { 0.0, 8.0, 0.0 } };
  body.triangles = { { 0, 1, 2 } };
  const auto kernel = uniformBody(body);
  for (const ContactSurface surface : { ContactSurface::Facets, ContactSurface::Smooth })
  {
    ContactSettings settings;
    settings.surface = surface;
    ToolContact contact(*kernel, settings);
    for (const double depth : { 0.01, 0.5, 2.0 })
    {
      contact.reset();
      const Contact felt = contact.update({ 2.0, 3.0, -depth });
      // The curve is stored as floats.
      EXPECT_NEAR(felt.normalForce, law(depth), 2e-7 * law(depth)) << depth;
      EXPECT_NEAR(felt.deflection, depth, 1e-12);
      EXPECT_EQ(felt.triangle, 0);
      EXPECT_EQ(felt.normal, Vector3(0.0, 0.0, 1.0));
    }
    for (const Vector3& outside :
      { Vector3(2.0, 3.0, 0.1), Vector3(-5.0, -5.0, -1.0), Vector3(1e6, 1e6, -1e6) })
    {
      contact.reset();
      EXPECT_EQ(contact.update(outside).force, Vector3::Zero()) << outside.transpose();
    }
  }
}

TEST(ExtremeBodies, AHundredThousandPieces)
{
  constexpr int Side = 47; // 103 823 tetrahedra
  const Surface body = scatteredTetrahedra(Side, 3);
  ASSERT_GE(body.triangles.size(), 4e5);
  const auto kernel = uniformBody(body);
  EXPECT_EQ(kernel->surface.triangleCount(), body.triangles.size());
  EXPECT_EQ(kernel->surface.defects().borderEdges, 0U);
  const Surface rounded = body.rounded();

  std::mt19937 random(5);
  std::uniform_real_distribution<double> inBox(-Lattice, Lattice * Side);
  std::uniform_int_distribution<std::int32_t> anyPiece(0, Side * Side * Side - 1);
  ToolContact contact(*kernel);
  int touched = 0;
  for (int i = 0; i < 2000; ++i)
  {
    Vector3 tip(inBox(random), inBox(random), inBox(random));
    if (i % 2 == 0) // inside a tetrahedron, between its centre and a corner
    {
      const std::int32_t piece = anyPiece(random);
      Vector3 middle = Vector3::Zero();
      for (std::int32_t k = 0; k < 4; ++k)
      {
        middle += 0.25 * rounded.points[static_cast<std::size_t>(4 * piece + k)];
      }
      tip =
        middle + 0.3 * (rounded.points[static_cast<std::size_t>(4 * piece + i / 2 % 4)] - middle);
    }
    contact.reset();
    const Contact felt = contact.update(tip);
    // Every fiftieth tip is compared with all 415 thousand triangles.
    const Nearest nearest =
      nearestOf(rounded, tip, i % 50 == 0 ? allTriangles(rounded) : trianglesNear(tip, Side));
    const bool inside = nearest.triangle >= 0 && isInside(rounded, nearest.triangle / 4, tip);
    EXPECT_EQ(felt.state != ContactState::None, inside) << i;
    if (!inside)
    {
      continue;
    }
    ++touched;
    const auto depth = static_cast<double>(nearest.distance);
    EXPECT_NEAR(felt.deflection, depth, 1e-10) << i;
    EXPECT_EQ(felt.triangle / 4, nearest.triangle / 4) << i;
    EXPECT_NEAR(felt.normalForce, law(depth), 1e-6 * law(depth)) << i;
  }
  EXPECT_GE(touched, 1000);
}

TEST(ExtremeBodies, MemoryPerPieceDoesNotDependOnTheirNumber)
{
  const auto bytesPerPiece = [](int side)
  {
    const auto kernel = uniformBody(scatteredTetrahedra(side, 3));
    return static_cast<double>(kernel->surface.memory() + kernel->response.memory()) /
      (side * side * side);
  };
  const double many = bytesPerPiece(47);
  EXPECT_LT(many, 1.05 * bytesPerPiece(10)); // the part that each body has once
  // 4 triangles of 105 bytes and 4 records of 80 bytes.
  EXPECT_LT(many, 4.0 * (115.0 + 80.0));
}

TEST(ExtremeBodies, AKilometreAwayInDoubleAsAtTheOrigin)
{
  const Surface near = icosphere(20.0, 4);
  const Vector3 away(1e6, -1e6, 1e6);
  // The kernel's floats are relative to the body's centre. Their rounding is half a unit in the
  // last place at 20 mm, 1e-6 mm, for each of the three coordinates, in both bodies.
  const double corner = std::sqrt(3.0) * 0.96e-6;
  const FarError error = farError(near, moved(near, away), away);
  EXPECT_LE(error.depth, 2.0 * corner);
  EXPECT_LE(error.force, 2.0 * 1.5 * corner);
}

TEST(ExtremeBodies, AKilometreAwayInFloatOnAGridOfASixteenth)
{
  const Surface near = icosphere(20.0, 4);
  const Vector3 away(1e6, -1e6, 1e6);
  Surface far = moved(near, away);
  double largest = 0.0;
  for (Vector3& point : far.points)
  {
    const Vector3 stored = point.cast<float>().cast<double>();
    largest = std::max(largest, (stored - point).cwiseAbs().maxCoeff());
    point = stored;
  }
  EXPECT_GT(largest, 0.030);
  EXPECT_LE(largest, 0.03125); // half of 0.0625 mm
  // No point of the surface moves by more than √3/32 mm, so the distance from the surface changes
  // by at most this.
  const double corner = std::sqrt(3.0) / 32.0 + 2e-6;
  const FarError error = farError(near, far, away);
  EXPECT_GT(error.depth, 0.01); // the rounding has a measurable effect
  EXPECT_LE(error.depth, corner);
  EXPECT_GT(error.force, 0.01);
  EXPECT_LE(error.force, std::pow(1.0 + corner, 1.5) - 1.0); // 8.2 % at 1 mm
}
} // namespace palpate::testing
