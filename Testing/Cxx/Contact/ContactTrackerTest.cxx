// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ContactTracker.h"

#include "SampleBodies.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <limits>

using namespace palpate::testing;
using palpate::ContactTracker;
using palpate::NotANumber;
using palpate::PackedMesh;
using palpate::TriangleTree;
using palpate::Vector3;
using Outcome = ContactTracker::Outcome;

namespace
{
struct Tracked
{
  explicit Tracked(const Surface& body)
    : mesh(body.packed())
    , tree(mesh)
    , tracker(mesh, tree)
  {
  }
  PackedMesh mesh;
  TriangleTree tree;
  ContactTracker tracker;
};

} // namespace

TEST(ContactTracker, ThinSlabKeepsTheSideItWasEnteredBy)
{
  // A slab of 4 mm, pressed from the top (z = 4) to a depth of 3.9 mm with some sliding.
  Tracked slab(subdivided(block(40, 40, 4), 4));
  for (int i = 0; i <= 390; ++i)
  {
    const double depth = 0.01 * i;
    const Vector3 tip(15.3 + 0.01 * i, 17.1, 4.0 - depth);
    const ContactTracker::Result contact = slab.tracker.update(tip);
    ASSERT_EQ(contact.outcome, i > 0 ? Outcome::Inside : Outcome::Outside) << depth;
    EXPECT_EQ(contact.place.projection.point.z(), 4.0);
    EXPECT_NEAR(contact.place.signedDistance, -depth, 1e-14); // 4 - (4 - depth) is rounded
    if (depth > 2.01)
    {
      // The nearest point of the whole surface is now on the other side.
      EXPECT_EQ(slab.tree.closest(tip).projection.point.z(), 0.0);
    }
  }
  // Without a history the contact of the same tip is at the bottom.
  slab.tracker.reset();
  EXPECT_EQ(slab.tracker.update(Vector3(19.2, 17.1, 0.1)).place.projection.point.z(), 0.0);
}

TEST(ContactTracker, LeavingEndsTheContact)
{
  Tracked ball(icosphere(20.0, 3));
  EXPECT_EQ(ball.tracker.update(Vector3(0, 0, 25)).outcome, Outcome::Outside);
  EXPECT_EQ(ball.tracker.update(Vector3(0, 0, 19)).outcome, Outcome::Inside);
  const ContactTracker::Result left = ball.tracker.update(Vector3(0, 0, 20.5));
  EXPECT_EQ(left.outcome, Outcome::Outside);
  EXPECT_GT(left.place.signedDistance, 0.0);
  // The entry from the other side does not depend on the first contact.
  const ContactTracker::Result again = ball.tracker.update(Vector3(0, 0, -19));
  EXPECT_EQ(again.outcome, Outcome::Inside);
  EXPECT_LT(again.place.projection.point.z(), -18.0);
}

TEST(ContactTracker, OnTheSurfaceIsOutside)
{
  Tracked slab(block(40, 40, 4));
  EXPECT_EQ(slab.tracker.update(Vector3(11, 7, 4)).outcome, Outcome::Outside);
  EXPECT_EQ(slab.tracker.update(Vector3(11, 7, std::nextafter(4.0, 0.0))).outcome, Outcome::Inside);
}

TEST(ContactTracker, OpenBorderLosesTheContact)
{
  Tracked plate(openPlate(10.0, 10));
  EXPECT_EQ(plate.tracker.update(Vector3(8.5, 5.2, -0.5)).outcome, Outcome::Inside);
  EXPECT_EQ(plate.tracker.update(Vector3(9.5, 5.2, -0.5)).outcome, Outcome::Inside);
  EXPECT_EQ(plate.tracker.update(Vector3(10.5, 5.2, -0.5)).outcome, Outcome::Border);
  EXPECT_EQ(plate.tracker.update(Vector3(11.5, 11.2, -0.5)).outcome, Outcome::Border);
  // A tip above the plane of the plate has no contact, over the plate or next to it.
  EXPECT_EQ(plate.tracker.update(Vector3(10.5, 5.2, 0.5)).outcome, Outcome::Outside);
  EXPECT_EQ(plate.tracker.update(Vector3(5.5, 5.2, 0.5)).outcome, Outcome::Outside);
  EXPECT_EQ(plate.tracker.update(Vector3(5.5, 5.2, -0.5)).outcome, Outcome::Inside);
}

TEST(ContactTracker, NaNForgetsTheContact)
{
  Tracked slab(subdivided(block(40, 40, 4), 3));
  for (const Vector3& bad : { Vector3(NotANumber, 0, 0), Vector3(0, 0, NotANumber),
         Vector3(0, std::numeric_limits<double>::infinity(), 0) })
  {
    slab.tracker.reset();
    EXPECT_EQ(slab.tracker.update(Vector3(20, 20, 3.5)).outcome, Outcome::Inside);
    // The tip is below the middle, but its history keeps the contact at the top.
    EXPECT_EQ(slab.tracker.update(Vector3(20, 20, 1.5)).place.projection.point.z(), 4.0);
    const ContactTracker::Result invalid = slab.tracker.update(bad);
    EXPECT_EQ(invalid.outcome, Outcome::Invalid);
    EXPECT_EQ(invalid.place.triangle, -1);
    // After the invalid tip the history is gone, and the nearer side counts.
    EXPECT_EQ(slab.tracker.update(Vector3(20, 20, 1.5)).place.projection.point.z(), 0.0);
  }
}

TEST(ContactTracker, BodyWithoutTriangles)
{
  Tracked nothing(Surface{});
  EXPECT_EQ(nothing.tracker.update(Vector3::Zero()).outcome, Outcome::Invalid);
}

TEST(ContactTracker, EntersAnotherWallInTheTickItLeavesOne)
{
  // Two blocks at a distance of 2 mm: the tip leaves the first block through the side where it
  // entered, and enters the second.
  Surface both = subdivided(block(10, 10, 10), 2);
  const Surface other = both;
  const auto shift = static_cast<std::int32_t>(both.points.size());
  for (const Vector3& p : other.points)
  {
    both.points.push_back(p + Vector3(12, 0, 0));
  }
  for (const auto& t : other.triangles)
  {
    both.triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
  Tracked walls(both);
  EXPECT_EQ(walls.tracker.update(Vector3(11, 5.1, 5.2)).outcome, Outcome::Outside);
  EXPECT_EQ(walls.tracker.update(Vector3(9.5, 5.1, 5.2)).place.projection.point.x(), 10.0);
  const ContactTracker::Result next = walls.tracker.update(Vector3(12.25, 5.1, 5.2));
  EXPECT_EQ(next.outcome, Outcome::Inside);
  EXPECT_EQ(next.place.projection.point.x(), 12.0);
  EXPECT_EQ(next.place.signedDistance, -0.25);
}

TEST(ContactTracker, FollowsFurtherThanOneRingInOneTick)
{
  // 30 mm in one tick across cells of 0.6 mm: about 50 rings, fewer than the limit of 256.
  Tracked slab(subdivided(block(40, 40, 4), 6));
  EXPECT_EQ(slab.tracker.update(Vector3(5, 20.1, 3.5)).outcome, Outcome::Inside);
  const ContactTracker::Result contact = slab.tracker.update(Vector3(35, 20.1, 1.0));
  EXPECT_EQ(contact.outcome, Outcome::Inside);
  // The contact stays at the top although the bottom is nearer.
  EXPECT_LE((contact.place.projection.point - Vector3(35, 20.1, 4)).norm(), 1e-13);
}
