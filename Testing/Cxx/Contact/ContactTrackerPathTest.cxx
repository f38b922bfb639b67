// SPDX-License-Identifier: BSD-3-Clause
// A tip presses and slides. In every tick the contact is the nearest point of the triangles within
// two rings of the last contact. The tests find this point by enumeration.
#include "BruteForce.h"
#include "BumpySphere.h"
#include "Contact/ContactTracker.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

using namespace palpate::testing;
using palpate::ContactTracker;
using palpate::PackedMesh;
using palpate::Pi;
using palpate::TriangleTree;
using palpate::Vector3;
using Outcome = ContactTracker::Outcome;

namespace
{
/// Follows the path for t in [0, 1]. Returns the number of ticks in contact.
int followPath(const Surface& given, int ticks, const std::function<Vector3(double)>& path)
{
  const Surface body = given.rounded();
  const PackedMesh mesh = body.packed();
  const TriangleTree tree(mesh);
  ContactTracker tracker(mesh, tree);
  const double tolerance = 1e-12 * diagonal(body); // rounding of the coordinates
  const std::vector<std::int32_t> all = allTriangles(body);
  std::int32_t last = -1;
  int inContact = 0;
  for (int i = 0; i <= ticks; ++i)
  {
    const Vector3 tip = path(static_cast<double>(i) / ticks);
    const ContactTracker::Result contact = tracker.update(tip);
    const Nearest nearest = nearestOf(body, tip, last >= 0 ? twoRings(body, last) : all);
    const bool inside = windingNumber(body, tip) > 0.5;
    EXPECT_EQ(contact.outcome, inside ? Outcome::Inside : Outcome::Outside) << "tick " << i;
    if (inside)
    {
      ++inContact;
      EXPECT_NEAR(-contact.place.signedDistance, static_cast<double>(nearest.distance), tolerance)
        << "tick " << i;
      EXPECT_LE((contact.place.projection.point.cast<long double>() - nearest.point).norm(),
        static_cast<long double>(1e3 * tolerance)) // √ of the rounding of a squared distance
        << "tick " << i;
    }
    last = inside ? mesh.inputTriangle(contact.place.triangle) : -1;
  }
  return inContact;
}

} // namespace

TEST(ContactTrackerPath, OverASphere)
{
  // Facets of 3 mm, depths of up to 1.5 mm, 0.13 mm per tick. The contact ends twice on the path.
  const int contacts = followPath(icosphere(20.0, 3), 800,
    [](double t)
    {
      const double depth = 0.4 + 1.1 * std::sin(6.0 * Pi * t);
      const double polar = 0.3 + 2.4 * t;
      const double azimuth = 1.7 * t;
      return Vector3((20.0 - depth) *
        Vector3(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
          std::cos(polar)));
    });
  EXPECT_GT(contacts, 400);
  EXPECT_LT(contacts, 750);
}

TEST(ContactTrackerPath, AroundATorus)
{
  // Through the hole of the torus, where the surface has the shape of a saddle.
  const int contacts = followPath(torus(20.0, 6.0, 60, 30), 600,
    [](double t)
    {
      const double u = 2.5 * t;
      const double v =
        0.4 + 2.0 * Pi * t; // away from the plane of symmetry, where two facets are equally near
      const double r = 6.0 - 0.3 - 0.5 * std::sin(10.0 * Pi * t);
      const double radius = 20.0 + r * std::cos(v);
      return Vector3(radius * std::cos(u), radius * std::sin(u), r * std::sin(v));
    });
  EXPECT_GT(contacts, 300);
  EXPECT_LT(contacts, 600);
}

TEST(ContactTrackerPath, OverAVGroove)
{
  // 0.6 mm below the surface, under the bottom of the groove and up its other wall. Below the
  // concave edge a whole range of tips has the same closest line. At convex rims the nearest
  // surface changes; the other face is 0.6 mm away, within the two rings.
  const int contacts = followPath(subdivided(grooveBlock(), 3), 500,
    [](double t)
    {
      const double x = -12.0 + 24.0 * t;
      const double surface = std::min(10.0, 5.0 + std::abs(x));
      return Vector3(x, surface - 0.6, 15.0 + 8.0 * t);
    });
  EXPECT_EQ(contacts, 501);
}

TEST(ContactTrackerPath, SeesWhereItWillBe)
{
  // Facets of 0.4 and 4 mm, 0.1 and 1.6 mm per tick, at a depth of 1 mm.
  for (const int cuts : { 50, 500 })
  {
    const Surface body = bumpySphere(cuts);
    const PackedMesh mesh = body.packed();
    const TriangleTree tree(mesh);
    for (const double step : { 0.1, 1.6 })
    {
      ContactTracker tracker(mesh, tree);
      EXPECT_EQ(tracker.triangleAhead(bumpyPoint(Vector3::UnitX())), -1); // there is no contact yet
      const std::vector<Vector3> tips = windingTips(1000, 1.0, step);
      tracker.update(tips[0]);
      int seen = 0;
      for (std::size_t i = 1; i + 1 < tips.size(); ++i)
      {
        tracker.update(tips[i]);
        const std::int32_t ahead = tracker.triangleAhead(2.0 * tips[i] - tips[i - 1]);
        ASSERT_GE(ahead, 0);
        ASSERT_EQ(tracker.triangleAhead(Vector3::Constant(std::nan(""))), tracker.triangle());
        ASSERT_GE(tracker.triangleAhead(Vector3::Constant(1e300)), 0);
        ContactTracker next = tracker;
        next.update(tips[i + 1]);
        seen += next.triangle() == ahead ? 1 : 0;
      }
      EXPECT_GT(seen, 900) << cuts << " cuts, " << step << " mm";
    }
  }
}
