// SPDX-License-Identifier: BSD-3-Clause
// The smooth contact from tick to tick: where it begins, which contact it keeps, and when the
// facets replace it.
#include "Contact/ContactBody.h"
#include "Contact/ContactTracker.h"

#include "SampleResponses.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace palpate::testing;
using palpate::ContactTracker;
using palpate::Vector3;
using Outcome = palpate::ContactTracker::Outcome;

namespace
{
ContactTracker trackerOn(const palpate::ContactBody& body)
{
  return ContactTracker(body.surface, body.tree, body.response);
}
} // namespace

TEST(SmoothTracker, BeginsAtTheSmoothSurface)
{
  // A ball of 80 triangles with a radius of 20 mm. In the middle of a facet the smooth surface is
  // 1.3 mm higher than the facet.
  const Surface surface = icosphere(20.0, 1);
  ResponseStore store(surface.points.size());
  store.normalsFromPoints(surface);
  const auto body = contactBody(surface, store);
  ContactTracker tracker = trackerOn(*body);
  for (std::int32_t t = 0; t < 80; t += 7)
  {
    const Vector3 middle =
      (surface.corner(t, 0) + surface.corner(t, 1) + surface.corner(t, 2)) / 3.0;
    const Vector3 out = middle.normalized();
    EXPECT_LT(middle.norm(), 19.0);
    // The patch is within 0.03 mm of the sphere; its triangles are half as wide as the radius.
    tracker.reset();
    EXPECT_EQ(tracker.update(20.1 * out).outcome, Outcome::Outside);
    EXPECT_EQ(tracker.triangle(), -1);
    const ContactTracker::Result first = tracker.update(19.9 * out);
    EXPECT_EQ(first.outcome, Outcome::Inside);
    EXPECT_TRUE(first.place.isSmooth);
    EXPECT_NEAR(first.place.signedDistance, -0.1, 0.05);
    EXPECT_EQ(tracker.triangle(), first.place.triangle);
    EXPECT_EQ(tracker.update(20.1 * out).outcome, Outcome::Outside);
  }
  EXPECT_EQ(tracker.update(Vector3(500, 0, 0)).outcome, Outcome::Outside);
}

TEST(SmoothTracker, FlatSidesStayFlat)
{
  // Bodies whose sides turn by 20° to 60° and back: patches through the mean normals would bulge by
  // up to a quarter of the length of a side. The depth under the middle of each triangle is the
  // distance from its plane.
  std::vector<Surface> bodies{ grooveBlock(), angleBlock() };
  for (const int sides : { 6, 9, 12 })
  {
    std::vector<Eigen::Vector2d> polygon;
    std::vector<std::array<std::int32_t, 3>> caps;
    for (int i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * M_PI * i / sides;
      polygon.emplace_back(20.0 * std::cos(angle), 20.0 * std::sin(angle));
    }
    for (std::int32_t i = 1; i + 1 < sides; ++i)
    {
      caps.push_back({ 0, i, i + 1 });
    }
    bodies.push_back(prism(polygon, caps, 30.0));
  }
  for (const Surface& surface : bodies)
  {
    const auto body = uniformBody(surface);
    ContactTracker tracker = trackerOn(*body);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const auto at = static_cast<std::int32_t>(t);
      const Vector3 a = surface.corner(at, 0);
      const Vector3 normal =
        (surface.corner(at, 1) - a).cross(surface.corner(at, 2) - a).normalized();
      const Vector3 middle = (a + surface.corner(at, 1) + surface.corner(at, 2)) / 3.0;
      constexpr double depth = 0.1; // the nearest edge is farther away
      tracker.reset();
      const ContactTracker::Result found = tracker.update(middle - depth * normal);
      EXPECT_EQ(found.outcome, Outcome::Inside);
      EXPECT_NEAR(found.place.signedDistance, -depth, 1e-5) << "coordinates are floats";
    }
  }
}

TEST(SmoothTracker, KeepsToTheSideItEntered)
{
  // A flat cushion, 40 mm wide and 6 mm thick: the contact does not change sides at half of the
  // thickness.
  Surface surface = icosphere(20.0, 3);
  for (Vector3& p : surface.points)
  {
    p.z() *= 0.15;
    // the body's coordinates differ from the local ones of the mesh
    p += Vector3(100.0, -50.0, 30.0);
  }
  const auto body = uniformBody(surface);
  ContactTracker tracker = trackerOn(*body);
  double last = 0.0;
  for (double depth = 0.05; depth < 5.0; depth += 0.05)
  {
    const auto contact = tracker.update(Vector3(101.0, -50.5, 33.0 - depth));
    ASSERT_EQ(contact.outcome, Outcome::Inside);
    EXPECT_GT(contact.place.normal.z(), 0.9);
    EXPECT_GT(contact.place.projection.point.z(), 32.5); // in the body's coordinates
    EXPECT_GT(-contact.place.signedDistance, last);
    last = -contact.place.signedDistance;
  }
  tracker.reset();
  EXPECT_LT(tracker.update(Vector3(101.0, -50.5, 28.0)).place.normal.z(), -0.9);
}

TEST(SmoothTracker, FollowsFastTips)
{
  // 10 m/s at 1 kHz over triangles of 1.4 mm: about ten triangles per tick.
  const auto body = [&]
  {
    const Surface surface = icosphere(20.0, 4);
    ResponseStore store(surface.points.size());
    store.normalsFromPoints(surface);
    return contactBody(surface, store);
  }();
  ContactTracker tracker = trackerOn(*body);
  for (int i = 0; i < 400; ++i)
  {
    const double angle = 0.5 * i;
    const Vector3 tip =
      19.0 * Vector3(std::cos(angle), std::sin(angle), std::sin(0.1 * i)).normalized();
    const auto contact = tracker.update(tip);
    ASSERT_EQ(contact.outcome, Outcome::Inside);
    EXPECT_TRUE(contact.place.isSmooth);
    EXPECT_LE((contact.place.projection.point - tip * (20.0 / 19.0)).norm(), 1e-4);
  }
}

TEST(SmoothTracker, FacetsStepInAtCreasesAndBack)
{
  // The top of a block is smooth and flat. A single normal that is parallel to the top makes a
  // crease.
  const Surface surface = subdivided(block(40, 40, 40), 3);
  ResponseStore store(surface.points.size());
  takeMeshNormals(store, surface);
  std::size_t middle = 0; // middle of the top
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    if ((surface.points[p] - Vector3(20, 20, 40)).norm() < 1e-9)
    {
      middle = p;
    }
  }
  store.normal[3 * middle] = 1.0F;
  store.normal[3 * middle + 2] = 0.0F;
  const auto body = contactBody(surface, store);
  ContactTracker tracker = trackerOn(*body);
  bool wasFacet = false;
  for (double x = 10.0; x < 30.0; x += 0.1)
  {
    const auto contact = tracker.update(Vector3(x, 20.7, 39.0));
    ASSERT_EQ(contact.outcome, Outcome::Inside);
    // Near the crease the surface is flat, so both surfaces have the same point.
    EXPECT_LE((contact.place.projection.point - Vector3(x, 20.7, 40.0)).norm(), 1e-9);
    EXPECT_LE((contact.place.normal - Vector3(0, 0, 1)).norm(), 1e-9);
    EXPECT_NEAR(contact.place.weightGradients.sum(), 0.0, 1e-12);
    const auto& corners = body->surface.corners(contact.place.triangle);
    const bool atCrease = std::any_of(corners.begin(), corners.end(),
      [&](std::int32_t corner)
      { return body->surface.inputPoint(corner) == static_cast<std::int32_t>(middle); });
    EXPECT_EQ(contact.place.isSmooth, !atCrease) << x;
    wasFacet = wasFacet || !contact.place.isSmooth;
  }
  EXPECT_TRUE(wasFacet);
}

TEST(SmoothTracker, BoxesStayBoxes)
{
  // Twelve triangles whose corner normals are tilted by 55° against the faces. They must not be
  // replaced by a smooth cushion.
  const auto body = uniformBody(block(40, 40, 40));
  ContactTracker tracker = trackerOn(*body);
  for (double x = 3.0; x < 38.0; x += 1.0)
  {
    EXPECT_EQ(tracker.update(Vector3(x, 21.3, 40.1)).outcome, Outcome::Outside);
    const auto contact = tracker.update(Vector3(x, 21.3, 39.0));
    ASSERT_EQ(contact.outcome, Outcome::Inside);
    EXPECT_FALSE(contact.place.isSmooth);
    EXPECT_NEAR(contact.place.signedDistance, -1.0, 1e-12);
    EXPECT_LE((contact.place.normal - Vector3(0, 0, 1)).norm(), 1e-12);
  }
}

TEST(SmoothTracker, OpenBordersAndWrongTips)
{
  const Surface plate = openPlate(10.0, 10);
  const auto body = contactBody(plate, ResponseStore(plate.points.size()));
  ContactTracker tracker = trackerOn(*body);
  EXPECT_EQ(tracker.update(Vector3(9.4, 5.2, -0.5)).outcome, Outcome::Inside);
  EXPECT_EQ(tracker.update(Vector3(10.2, 5.2, -0.5)).outcome, Outcome::Border);
  EXPECT_EQ(tracker.update(Vector3(10.2, 5.2, 0.5)).outcome, Outcome::Outside);
  EXPECT_EQ(tracker.update(Vector3(9.4, 5.2, -0.5)).outcome, Outcome::Inside);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(tracker.update(Vector3(9.4, nan, -0.5)).outcome, Outcome::Invalid);
  EXPECT_EQ(tracker.triangle(), -1);
  const auto nothing = uniformBody(Surface{});
  ContactTracker lost = trackerOn(*nothing);
  EXPECT_EQ(lost.update(Vector3::Zero()).outcome, Outcome::Invalid);
}

TEST(SmoothTracker, FindsAContactWhereverTheTipAppears)
{
  // Tips at random places inside a torus, one after the other, are never invalid and always in
  // contact.
  const auto body = uniformBody(torus(20.0, 6.0, 60, 30));
  ContactTracker tracker = trackerOn(*body);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> turn(0.0, 6.283185307179586);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 3000; ++i)
  {
    const double u = turn(random);
    const double v = turn(random);
    const double r = 5.7 * share(random);
    const double across = 20.0 + r * std::cos(v);
    const Vector3 tip(across * std::cos(u), across * std::sin(u), r * std::sin(v));
    const auto contact = tracker.update(tip);
    ASSERT_EQ(contact.outcome, Outcome::Inside) << i;
    EXPECT_GT(-contact.place.signedDistance, 0.2); // at least 0.3 mm, minus the depth of the facets
    EXPECT_TRUE(contact.place.projection.point.allFinite());
    EXPECT_NEAR(contact.place.projection.weights.sum(), 1.0, 1e-12);
  }
}
