// SPDX-License-Identifier: BSD-3-Clause
// The closest point of the smooth surface: its search, its continuity, its derivatives, and cases
// without a point.
#include "Contact/ContactBody.h"
#include "Contact/ContactTracker.h"
#include "Contact/SmoothContact.h"

#include "SampleResponses.h"
#include "Sanitized.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

using namespace palpate::testing;
using palpate::ContactBody;
using palpate::ContactPlace;
using palpate::ContactTracker;
using palpate::SmoothContact;
using palpate::SmoothPoint;
using palpate::SmoothTriangle;
using palpate::SurfaceJet;
using palpate::SurfacePoint;
using palpate::Vector3;

namespace
{

/// A torus with unequal triangles and randomly moved points, which is not convex and has no
/// symmetry.
std::unique_ptr<ContactBody> crookedBody()
{
  Surface body = torus(20.0, 8.0, 25, 11);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-0.2, 0.2);
  for (Vector3& p : body.points)
  {
    for (double& coordinate : p)
    {
      coordinate += share(random);
    }
  }
  return uniformBody(body);
}

std::unique_ptr<ContactBody> ball(int times)
{
  const Surface body = icosphere(20.0, times);
  ResponseStore store(body.points.size());
  store.normalsFromPoints(body);
  return contactBody(body, store);
}

SmoothPoint onset(const ContactBody& body, SmoothContact& contact, const Vector3& tip)
{
  const SurfacePoint near = body.tree.closestLocal(tip);
  return contact.follow(tip, near.triangle, near.projection.weights);
}

/// Smallest distance of a tip from a dense set of points on the patches within two rings of a
/// triangle.
double cloudDistance(const ContactBody& body, const Vector3& tip, std::int32_t triangle)
{
  double least = std::numeric_limits<double>::infinity();
  const auto tryPatch = [&](std::int32_t t)
  {
    SmoothTriangle patch;
    const auto& corners = body.surface.corners(t);
    ASSERT_TRUE(patch.build(
      { body.surface.corner(t, 0), body.surface.corner(t, 1), body.surface.corner(t, 2) },
      { body.response.normal(corners[0]), body.response.normal(corners[1]),
        body.response.normal(corners[2]) }));
    constexpr int n = 40;
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; i + j <= n; ++j)
      {
        const Vector3 u(1.0 - (i + j) / double{ n }, i / double{ n }, j / double{ n });
        least = std::min(least, (patch.evaluate(u).point - tip).norm());
      }
    }
  };
  for (const std::int32_t corner : body.surface.corners(triangle))
  {
    body.surface.visitAround(corner, tryPatch);
  }
  return least;
}

/// A random tip below or above a random facet of the body.
struct Start
{
  std::int32_t triangle;
  Vector3 weights;
  Vector3 tip;
};
Start anyStart(const ContactBody& body, std::mt19937& random, double depth)
{
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Start start;
  start.triangle = static_cast<std::int32_t>(
    share(random) * static_cast<double>(body.surface.triangleCount() - 1));
  const double s = std::sqrt(share(random));
  const double t = share(random);
  start.weights = { 1.0 - s, s * (1.0 - t), s * t };
  start.tip = -depth * body.surface.faceNormal(start.triangle);
  for (int k = 0; k < 3; ++k)
  {
    start.tip += start.weights[k] * body.surface.corner(start.triangle, k);
  }
  return start;
}
} // namespace

TEST(SmoothContact, IsTheFootOfThePerpendicularAndNoneIsNearer)
{
  const auto body = crookedBody();
  SmoothContact contact(body->surface, body->response);
  std::mt19937 random(1);
  int found = 0;
  for (int i = 0; i < casesOf(400); ++i)
  {
    const double depth = i % 4 - 1.0; // -1 (outside), 0, 1 or 2 mm (inside)
    const Start start = anyStart(*body, random, depth);
    const SmoothPoint point = contact.follow(start.tip, start.triangle, start.weights);
    ASSERT_EQ(point.outcome, SmoothPoint::Outcome::Found) << i;
    const ContactPlace& place = point.place;
    ++found;
    EXPECT_GE(place.projection.weights.minCoeff(), 0.0);
    EXPECT_NEAR(place.projection.weights.sum(), 1.0, 1e-15);
    EXPECT_NEAR(place.normal.norm(), 1.0, 1e-15);
    // Newton's last step is below 1e-6 of a triangle 5 mm wide. The error is the square of this.
    const Vector3 offset = start.tip - place.projection.point;
    EXPECT_LE((offset - place.signedDistance * place.normal).norm(), 1e-10);
    // A point of the dense set is up to 5 mm/40 away from the foot: at most (0.06)²/2δ farther from
    // the tip, and never nearer.
    const double cloud = cloudDistance(*body, start.tip, place.triangle);
    EXPECT_LE(std::abs(place.signedDistance), cloud + 1e-10);
    EXPECT_GT(std::abs(place.signedDistance), cloud - 0.15);
  }
  EXPECT_EQ(found, casesOf(400));
}

TEST(SmoothContact, TheSameFromAnyTriangleNearby)
{
  // The search also starts several triangles away, so that it crosses edges.
  const auto body = ball(3);
  SmoothContact contact(body->surface, body->response);
  std::mt19937 random(2);
  for (int i = 0; i < 300; ++i)
  {
    const Start start = anyStart(*body, random, 1.0);
    const SmoothPoint near = contact.follow(start.tip, start.triangle, start.weights);
    const Vector3 aside = start.tip + 12.0 * start.tip.unitOrthogonal();
    const SurfacePoint far = body->tree.closestLocal(aside);
    const SmoothPoint came = contact.follow(start.tip, far.triangle, far.projection.weights);
    ASSERT_EQ(near.outcome, SmoothPoint::Outcome::Found);
    ASSERT_EQ(came.outcome, SmoothPoint::Outcome::Found);
    EXPECT_LE((near.place.projection.point - came.place.projection.point).norm(), 1e-9);
    EXPECT_LE((near.place.normal - came.place.normal).norm(), 1e-9);
  }
}

TEST(SmoothContact, NothingJumpsAcrossEdges)
{
  const auto body = crookedBody();
  SmoothContact contact(body->surface, body->response);
  const double step = 1e-8;
  int crossings = 0;
  std::mt19937 random(4);
  for (int way = 0; way < 60; ++way)
  {
    const Start start = anyStart(*body, random, 1.0);
    const Vector3 towards = start.tip.unitOrthogonal();
    const auto tipAt = [&](double s) -> Vector3 { return start.tip + s * towards; };
    SmoothPoint last = contact.follow(start.tip, start.triangle, start.weights);
    for (double s = 0.0; s < 3.0; s += 0.05)
    {
      const SmoothPoint next =
        contact.follow(tipAt(s + 0.05), last.place.triangle, last.place.projection.weights);
      ASSERT_EQ(next.outcome, SmoothPoint::Outcome::Found);
      if (next.place.signedDistance < -1.5)
      {
        break; // the smallest radius of the irregular body is slightly above 2 mm
      }
      if (next.place.triangle != last.place.triangle)
      {
        // Finds the crossing by bisection.
        double low = s;
        double high = s + 0.05;
        SmoothPoint before = last;
        SmoothPoint after = next;
        while (high - low > step)
        {
          const double middle = 0.5 * (low + high);
          const SmoothPoint there =
            contact.follow(tipAt(middle), before.place.triangle, before.place.projection.weights);
          const bool same = there.place.triangle == before.place.triangle;
          (same ? low : high) = middle;
          (same ? before : after) = there;
        }
        ++crossings;
        // Point and normal move by the step divided by 1 - δ/R, a factor below 20.
        EXPECT_LE(
          (after.place.projection.point - before.place.projection.point).norm(), 20.0 * step);
        EXPECT_LE((after.place.normal - before.place.normal).norm(), 20.0 * step);
        EXPECT_NEAR(after.place.signedDistance, before.place.signedDistance, 2.0 * step);
        // On the common edge the opposite corner has no weight on either side.
        EXPECT_LE(before.place.projection.weights.minCoeff(), 20.0 * step);
        EXPECT_LE(after.place.projection.weights.minCoeff(), 20.0 * step);
      }
      last = next;
    }
  }
  EXPECT_GT(crossings, 40);
}

TEST(SmoothContact, WeightGradients)
{
  const auto body = crookedBody();
  SmoothContact contact(body->surface, body->response);
  std::mt19937 random(5);
  const double e = 1e-5;
  int compared = 0;
  for (int i = 0; i < 300; ++i)
  {
    const Start start = anyStart(*body, random, 0.5 + 0.005 * i);
    const SmoothPoint here = contact.follow(start.tip, start.triangle, start.weights);
    ASSERT_EQ(here.outcome, SmoothPoint::Outcome::Found);
    const ContactPlace& place = here.place;
    if (place.projection.weights.minCoeff() <
      0.02) // away from corners and edges, where the gradients jump
    {
      continue;
    }
    ++compared;
    Eigen::Matrix3d expected;
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      const Vector3 step = e * Vector3::Unit(k);
      expected.row(k) = (contact.follow(start.tip + step, place.triangle, place.projection.weights)
                            .place.projection.weights -
                          contact.follow(start.tip - step, place.triangle, place.projection.weights)
                            .place.projection.weights) /
        (2.0 * e);
    }
    // e² times third derivatives, and 1e-12 / e. The Hessian is that of the step before the last,
    // 1e-6 away.
    EXPECT_LE((place.weightGradients - expected).norm(), 3e-6 * (1.0 + expected.norm()));
    EXPECT_LE((place.weightGradients.transpose() * place.normal).norm(), 1e-9);
  }
  EXPECT_GT(compared, 150);
}

TEST(SmoothContact, DepthOfASphere)
{
  // 1280 triangles, 2.8 mm wide: an error of 0.005 h⁴/R³ (SmoothTriangleTest). Facets are 0.07 mm
  // inside the sphere.
  const auto body = ball(3);
  SmoothContact contact(body->surface, body->response);
  std::mt19937 random(6);
  for (const double depth : { 0.5, 5.0, 15.0, 19.0 })
  {
    for (int i = 0; i < 200; ++i)
    {
      const Vector3 tip = (20.0 - depth) * anyStart(*body, random, 0.0).tip.normalized();
      const SmoothPoint point = onset(*body, contact, tip);
      ASSERT_EQ(point.outcome, SmoothPoint::Outcome::Found);
      EXPECT_NEAR(-point.place.signedDistance, depth, 5e-5);
      // The normal of the patch has an error of 3e-5, below the surface times R/(R - δ).
      EXPECT_LE((point.place.normal - tip.normalized()).norm(), 1e-4 * 20.0 / (20.0 - depth));
    }
  }
}

TEST(SmoothContact, NotFoundBeyondTheCentreOfCurvature)
{
  const auto body = ball(3);
  SmoothContact contact(body->surface, body->response);
  const SurfacePoint side = body->tree.closestLocal(Vector3(19, 1, 2));
  const Vector3 n = Vector3(19, 1, 2).normalized();
  const auto at = [&](double depth)
  { return contact.follow((20.0 - depth) * n, side.triangle, side.projection.weights).outcome; };
  EXPECT_EQ(at(15.0), SmoothPoint::Outcome::Found);
  // Either no point is found, or a point of the far side, at a distance of at most the radius.
  for (double depth = 19.99; depth < 21.0; depth += 0.01)
  {
    const SmoothPoint point =
      contact.follow((20.0 - depth) * n, side.triangle, side.projection.weights);
    if (point.outcome == SmoothPoint::Outcome::Found)
    {
      EXPECT_LE(-point.place.signedDistance, 20.0);
    }
  }
}

TEST(SmoothContact, EndsAtAnOpenBorder)
{
  const Surface plate = openPlate(10.0, 10);
  const auto body = contactBody(plate, ResponseStore(plate.points.size()));
  SmoothContact contact(body->surface, body->response);
  const auto follow = [&](const Vector3& tip, const Vector3& from)
  {
    const SurfacePoint near = body->tree.closestLocal(from);
    return contact.follow(tip, near.triangle, near.projection.weights);
  };
  // in local coordinates, with the origin at the centre of the plate
  const Vector3 inside(4.4, 0.2, -0.5);
  EXPECT_EQ(follow(inside, inside).outcome, SmoothPoint::Outcome::Found);
  for (const double beyond : { 5.001, 5.2, 7.0 })
  {
    const SmoothPoint lost = follow(Vector3(beyond, 0.2, -0.5), inside);
    EXPECT_EQ(lost.outcome, SmoothPoint::Outcome::Border);
    EXPECT_LE((lost.place.projection.point - Vector3(5.0, 0.2, 0.0)).norm(), 1e-6);
    EXPECT_NEAR(lost.place.signedDistance, -0.5, 1e-12); // inside, by the normal at the border
  }
  EXPECT_EQ(follow(Vector3(5.2, 5.3, -0.5), inside).outcome, SmoothPoint::Outcome::Border);
  EXPECT_EQ(follow(Vector3(4.999, 0.2, -0.5), inside).outcome, SmoothPoint::Outcome::Found);
}

TEST(SmoothContact, NotFoundAtCreasesAndForTipsThatAreNotFinite)
{
  const Surface surface = subdivided(block(40, 40, 40), 3);
  ResponseStore store(surface.points.size());
  takeMeshNormals(store, surface);
  for (std::size_t k = 0; k < 3; ++k) // sets the same normal along a face of the block
  {
    store.normal[k] = k == 0 ? 1.0F : 0.0F;
  }
  const auto body = contactBody(surface, store);
  SmoothContact contact(body->surface, body->response);
  EXPECT_EQ(onset(*body, contact, Vector3(1.0, 2.0, 18.0)).outcome, SmoothPoint::Outcome::Found);
  const Vector3 corner = body->surface.toLocal(surface.points[0]);
  EXPECT_EQ(
    onset(*body, contact, corner + Vector3(0.5, 0.7, 0.1)).outcome, SmoothPoint::Outcome::NotFound);
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    EXPECT_EQ(contact.follow(Vector3(1.0, bad, 18.0), 0, Vector3(0.3, 0.3, 0.4)).outcome,
      SmoothPoint::Outcome::NotFound);
  }
}
