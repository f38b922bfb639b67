// SPDX-License-Identifier: BSD-3-Clause
// A tip that is very far away, very fast, or without a valid position: each tick gives a valid
// force and does not affect the next tick.
#include "BruteForce.h"
#include "BumpySphere.h"
#include "SampleResponses.h"
#include "Contact/ToolContact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace palpate::testing
{
namespace
{
/// A closed strip of 3 mm by 1 mm, `length` long, in cells of 0.1 mm by 1 mm. In the middle row of
/// its top no triangle has a common corner with a triangle of a side.
Surface longStrip(double length)
{
  const int cells = static_cast<int>(std::lround(10.0 * length));
  constexpr std::int32_t around = 8; // points around: bottom from y = 0 to 3, then top from 3 to 0
  Surface body;
  for (std::int32_t i = 0; i <= cells; ++i)
  {
    for (std::int32_t k = 0; k < around; ++k)
    {
      body.points.emplace_back(0.1 * i, k < 4 ? k : 7 - k, k < 4 ? 0 : 1);
      if (i < cells)
      {
        const std::int32_t a = around * i + k;
        const std::int32_t b = around * i + (k + 1) % around;
        body.triangles.push_back({ a, a + around, b + around });
        body.triangles.push_back({ a, b + around, b });
      }
    }
  }
  const std::int32_t last = around * cells;
  for (std::int32_t k = 0; k < 3; ++k)
  {
    body.triangles.push_back({ k, k + 1, 7 - k });
    body.triangles.push_back({ k + 1, 6 - k, 7 - k });
    body.triangles.push_back({ last + k, last + 7 - k, last + k + 1 });
    body.triangles.push_back({ last + k + 1, last + 7 - k, last + 6 - k });
  }
  if (body.mesh().enclosedVolume() < 0.0) // makes the winding outward
  {
    for (auto& t : body.triangles)
    {
      std::swap(t[0], t[1]);
    }
  }
  return body;
}

bool sameForce(const Contact& a, const Contact& b)
{
  return a.force == b.force && a.state == b.state && a.triangle == b.triangle &&
    a.contactPoint == b.contactPoint && a.deflection == b.deflection;
}
} // namespace

TEST(UnkindMotion, FarOutsideThenAnywhereInContact)
{
  const auto body = uniformBody(bumpySphere(30));
  ToolContact contact(*body);
  const std::vector<Vector3> tips = windingTips(60, 1.0, 17.0);
  std::size_t next = 0;
  for (const double far : { 1e3, 1e6, 1e9, 1e15, 1e30, 1e100 })
  {
    for (const Vector3& direction :
      { Vector3(1, 0, 0), Vector3(-0.3, 0.5, 0.8), Vector3(0, 0, -1) })
    {
      const Contact away = contact.update(far * direction);
      EXPECT_EQ(away.state, ContactState::None) << far;
      EXPECT_EQ(away.force, Vector3::Zero());
      const Vector3& tip = tips[++next % tips.size()];
      const Contact found = contact.update(tip);
      EXPECT_EQ(found.state, ContactState::Slide);
      // same force as without a history
      EXPECT_TRUE(sameForce(found, ToolContact(*body).update(tip)));
    }
  }
  // If squares of distances exceed the range of a double, there is no force, and the next contact
  // is valid.
  for (const double far : { 1e155, 1e200, std::numeric_limits<double>::max() })
  {
    EXPECT_EQ(contact.update(Vector3(-far, far, far)).force, Vector3::Zero());
    EXPECT_EQ(contact.update(tips[3]).state, ContactState::Slide);
  }
}

TEST(UnkindMotion, TenMetresPerSecondIsFollowed)
{
  // 10 mm per tick across facets of 1.6 mm. The contact of each tick is that of a new tip at the
  // same place, because the curvature of the bumps is small (see BumpySphere.h).
  const auto body = uniformBody(bumpySphere(100));
  ToolContact contact(*body);
  for (const Vector3& tip : windingTips(500, 1.0, 10.0))
  {
    const Contact found = contact.update(tip);
    EXPECT_EQ(found.state, ContactState::Slide);
    const Contact fresh = ToolContact(*body).update(tip);
    EXPECT_LE((found.contactPoint - fresh.contactPoint).norm(), 1e-9);
  }
}

TEST(UnkindMotion, AFastTipKeepsItsSideOfASlab)
{
  // A strip 1 mm thick, entered at the top, at a depth of 0.7 mm. With jumps of 20 mm, 200 cells
  // each, the contact stays at the top, since MaximumSteps is large enough.
  static_assert(ContactTracker::MaximumSteps >= 256, "what the header says of the speed");
  const auto body = uniformBody(longStrip(100.0));
  ASSERT_EQ(body->surface.defects().borderEdges + body->surface.defects().nonManifoldEdges, 0U);
  ToolContact contact(*body);
  contact.update(Vector3(1.03, 1.47, 0.8));
  for (int i = 0; i < 20; ++i)
  {
    const Contact found = contact.update(Vector3(i % 2 == 0 ? 21.03 : 1.03, 1.47, 0.3));
    EXPECT_EQ(found.contactPoint.z(), 1.0);
    EXPECT_NEAR(found.deflection, 0.7, 1e-5);
  }
}

TEST(UnkindMotion, ATipThatOutrunsTheStepsIsSearchedAnew)
{
  // 90 mm in a tick are 900 cells, more than MaximumSteps. The place that the steps reach would be
  // tens of millimetres away, so a new contact begins at the nearest surface: the top at a depth of
  // 0.3 mm, and the bottom at 0.7 mm, where a slower tip would have stayed at the top.
  const auto body = uniformBody(longStrip(100.0));
  for (const double depth : { 0.3, 0.7 })
  {
    ToolContact contact(*body);
    contact.update(Vector3(5.03, 1.47, 0.8));
    const Contact found = contact.update(Vector3(95.03, 1.47, 1.0 - depth));
    EXPECT_NEAR(found.deflection, 0.3, 1e-5);
    EXPECT_NEAR(found.contactPoint.x(), 95.03, 1e-5);
    EXPECT_EQ(found.force.z() > 0.0, depth < 0.5);
    // The next tick at the same place gives the same bits.
    EXPECT_TRUE(sameForce(contact.update(Vector3(95.03, 1.47, 1.0 - depth)), found));
  }
}

TEST(UnkindMotion, ThrownThroughTheBodyIsOutside)
{
  // From the top of a fine sphere to 1 m below it. The path around the sphere, 300 rows of
  // triangles, exceeds the steps, and the place at which they end is not a contact.
  const auto body = uniformBody(bumpySphere(150));
  ToolContact contact(*body);
  EXPECT_EQ(contact.update(Vector3(0.3, 0.2, 99.0)).state, ContactState::Slide);
  const Contact found = contact.update(Vector3(0, 0, -1000.0));
  EXPECT_EQ(found.state, ContactState::None);
  EXPECT_EQ(found.force, Vector3::Zero());
}
} // namespace palpate::testing
