// SPDX-License-Identifier: BSD-3-Clause
// Contact on meshes with typical defects: slivers, triangles without area, duplicate points,
// reversed triangles, edges of four triangles, bodies within bodies. The force is F = 10 δ^1.5 N.
#include "BruteForce.h"
#include "SampleResponses.h"
#include "Contact/ToolContact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace palpate::testing
{
namespace
{
/// A plate whose rows of points have random distances, down to a hundred-thousandth of the
/// distances of the columns: needles, caps and squares next to each other. Some rows occur twice,
/// without area in between.
Surface sliverPlate(int rows)
{
  std::mt19937 random(17);
  std::uniform_real_distribution<double> exponent(-5.0, 0.0);
  Surface body;
  double y = 0.0;
  constexpr int columns = 10;
  for (int i = 0; i <= rows; ++i)
  {
    for (int j = 0; j <= columns; ++j)
    {
      body.points.emplace_back(j, y, 0.0);
      if (i < rows && j < columns)
      {
        const std::int32_t at = i * (columns + 1) + j;
        const std::int32_t up = at + columns + 1;
        body.triangles.push_back({ at, at + 1, up + 1 });
        body.triangles.push_back({ at, up + 1, up });
      }
    }
    y += i % 7 == 3 ? 0.0 : std::pow(10.0, exponent(random));
  }
  return body;
}

/// Separate corners for each triangle, with every third triangle reversed.
Surface brokenUp(const Surface& body)
{
  Surface apart;
  for (const std::int32_t t : allTriangles(body))
  {
    const auto first = static_cast<std::int32_t>(apart.points.size());
    for (std::size_t k = 0; k < 3; ++k)
    {
      apart.points.push_back(body.corner(t, k));
    }
    const bool turned = t % 3 == 0;
    apart.triangles.push_back(
      { first, turned ? first + 2 : first + 1, turned ? first + 1 : first + 2 });
  }
  return apart;
}

/// Two boxes with the four points of the face between them in common. Both boxes contain this face,
/// so four triangles meet at each of its edges.
Surface twoCellsOfAGrid()
{
  Surface body = block(10, 10, 10);
  body.points.insert(
    body.points.end(), { { 20, 0, 0 }, { 20, 10, 0 }, { 20, 0, 10 }, { 20, 10, 10 } });
  // Points of the first box: 0 to 7, (0,0) (10,0) (10,10) (0,10) below, then above. Lower face of
  // the second box: 1, 8, 9, 2.
  const std::array<std::int32_t, 8> second = { 1, 8, 9, 2, 5, 10, 11, 6 };
  const Surface one = body;
  for (const auto& t : one.triangles)
  {
    body.triangles.push_back({ second[static_cast<std::size_t>(t[0])],
      second[static_cast<std::size_t>(t[1])], second[static_cast<std::size_t>(t[2])] });
  }
  return body;
}
} // namespace

TEST(UnkindMesh, SliversAreAsGoodAsSquares)
{
  const Surface surface = sliverPlate(120);
  const auto body = uniformBody(surface);
  EXPECT_GT(body->surface.defects().degenerate, 300U);
  EXPECT_GT(body->surface.defects().joinedPoints, 150U);
  EXPECT_EQ(body->surface.defects().nonManifoldEdges, 0U);
  const double length = surface.points.back().y();
  ASSERT_GT(length, 5.0);
  // A path across all rows at a depth of 0.5 mm, which meets every kind of triangle. Its steps are
  // from much smaller to much larger than a row.
  for (const double step : { 1e-4, 3e-3, 0.11 })
  {
    ToolContact contact(*body);
    const int ticks = std::min(20000, static_cast<int>(0.9 * length / step));
    for (int i = 0; i <= ticks; ++i)
    {
      const double y = 0.05 * length + step * i;
      const Contact found = contact.update(Vector3(5.0 + 3.0 * std::sin(y), y, -0.5));
      ASSERT_EQ(found.state, ContactState::Slide) << y;
      ASSERT_NEAR(found.deflection, 0.5, 1e-12); // the plate is flat also in float32
      // √ of the rounding of a squared distance, where two triangles are equally near.
      ASSERT_LE((found.contactPoint - Vector3(5.0 + 3.0 * std::sin(y), y, 0.0)).norm(), 1e-7);
      ASSERT_NEAR(found.force.z(), 10.0 * std::pow(0.5, 1.5), 1e-5);
    }
  }
}

TEST(UnkindMesh, BrokenUpItFeelsLikeOne)
{
  // A torus of separate triangles: each point occurs three or six times, and every third triangle
  // is reversed. After the repair the force is that of the torus with the responses of its points.
  const Surface whole = torus(20.0, 6.0, 40, 20);
  const Surface broken = brokenUp(whole);
  ResponseStore store(whole.points.size());
  takeMeshNormals(store, whole);
  store.randomizeCurves(3);
  ResponseStore copied(broken.points.size());
  for (std::size_t t = 0; t < broken.triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto from = static_cast<std::size_t>(whole.triangles[t][k]);
      const std::size_t to = 3 * t + k;
      copied.range[to] = store.range[from];
      std::copy_n(&store.normal[3 * from], 3, &copied.normal[3 * to]);
      std::copy_n(&store.force[8 * from], 8, &copied.force[8 * to]);
      std::copy_n(&store.stiffness[8 * from], 8, &copied.stiffness[8 * to]);
    }
  }
  const auto body = contactBody(whole, store);
  const auto mended = contactBody(broken, copied);
  EXPECT_EQ(mended->surface.defects().turnedTriangles, (whole.triangles.size() + 2) / 3);
  EXPECT_EQ(mended->surface.defects().joinedPoints, broken.points.size() - whole.points.size());
  EXPECT_EQ(mended->surface.defects().borderEdges, 0U);
  ToolContact contact(*body);
  ToolContact again(*mended);
  for (int i = 0; i < 4000; ++i)
  {
    const double u = 1e-3 * i;
    const double v = 2.7e-3 * i;
    const double r = 6.0 - 0.5 - 0.8 * std::sin(0.01 * i);
    const double radius = 20.0 + r * std::cos(v);
    const Vector3 tip(radius * std::cos(u), radius * std::sin(u), r * std::sin(v));
    const Contact found = contact.update(tip);
    const Contact other = again.update(tip);
    ASSERT_EQ(found.state, other.state);
    // Corners in another order cause other rounding: 40 N/mm times 1e-14 mm.
    ASSERT_LE((found.force - other.force).norm(), 1e-11);
  }
}

TEST(UnkindMesh, WallsInside)
{
  // Two cells have a common face, which is a wall for both; its edges have four triangles. A tip
  // moves across the wall 0.3 mm below the top. Near the wall the force is that of the wall,
  // elsewhere that of the top. The force is always finite, zero only on the wall itself, and never
  // pulls the tip deeper.
  const Surface surface = twoCellsOfAGrid();
  EXPECT_EQ(surface.packed().defects().nonManifoldEdges, 4U);
  const auto body = uniformBody(surface);
  ToolContact contact(*body);
  int onTop = 0;
  for (int i = 0; i <= 2000; ++i)
  {
    const double x = 5.003 + 5e-3 * i;
    const Contact found = contact.update(Vector3(x, 5.1, 9.7));
    ASSERT_EQ(found.state, ContactState::Slide) << x;
    ASSERT_NEAR(found.deflection, std::min(0.3, std::abs(x - 10.0)), 1e-12) << x;
    EXPECT_GE(found.force.z(), 0.0);
    onTop += found.contactPoint.z() == 10.0;
  }
  EXPECT_NEAR(onTop, 2000 - 120, 2); // 0.3 mm on either side of the wall
}

TEST(UnkindMesh, OverlappingBodiesKeepWhatTheyTouched)
{
  // Two balls of 10 mm with their centres 12 mm apart. Where both contain the tip, the ball that
  // the tip entered first keeps the contact, even if the surface of the other ball is nearer. This
  // has a limitation, because intersecting surfaces do not bound a volume: just outside the first
  // ball, but still in the second, the surface of the first ball is nearest and there is no force,
  // until the surface of the second ball is nearer.
  const Surface ball = icosphere(10.0, 4);
  const auto body = uniformBody(together(ball, ball, Vector3(12, 0, 0)));
  const auto first = static_cast<std::int32_t>(ball.triangles.size());
  ToolContact contact(*body);
  for (int i = 0; i <= 3000; ++i)
  {
    const double x = -9.0 + 0.01 * i; // 0.5 mm from the line of centres
    const Contact found = contact.update(Vector3(x, 0.5, 0.0));
    // Facets of 0.6 mm are h²/8R = 0.005 mm inside the ball; x = 16 is half-way between the
    // surfaces.
    if (x < 9.97)
    {
      EXPECT_LT(found.triangle, first);
      EXPECT_GT(found.normalForce, 0.0);
    }
    else if (x > 10.0 && x < 15.95)
    {
      EXPECT_EQ(found.state, ContactState::None);
    }
    else if (x > 16.05)
    {
      EXPECT_GE(found.triangle, first);
      EXPECT_GT(found.force.x(), 0.0);
    }
  }
}

TEST(UnkindMesh, NoTriangleAtAllIsNoContact)
{
  // Found by fuzzing: for a point without triangles an empty list was searched.
  Surface points;
  points.points = { Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0) };
  points.triangles = { { 0, 1, 1 } };
  const PackedMesh mesh = points.packed();
  EXPECT_EQ(mesh.triangleCount(), 0U);
  EXPECT_EQ(mesh.defects().degenerate, 1U);
  for (std::int32_t i = 0; i < 3; ++i)
  {
    mesh.visitAround(i, [](std::int32_t triangle) { ADD_FAILURE() << triangle; });
  }
  const auto body = uniformBody(points);
  ToolContact contact(*body);
  const Contact found = contact.update(Vector3(0.2, 0.2, -0.1));
  EXPECT_EQ(found.triangle, -1);
  EXPECT_TRUE(found.force.isZero(0.0));
}
} // namespace palpate::testing
