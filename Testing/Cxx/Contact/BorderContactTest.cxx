// SPDX-License-Identifier: BSD-3-Clause
// A tip slides off an open border: the contact is lost, the force fades with the position of the
// tip, and no force pulls the tip back. For every force form and contact surface, and with
// friction.
#include "SampleResponses.h"
#include "Contact/ToolContact.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::testing
{
TEST(BorderContact, LostAndFading)
{
  // F = 10 N at 1 mm. At a distance l (mm) beyond the border the force is (1 - l)² (1 + 2 l) times
  // 10 N, along z.
  const auto body = uniformBody(openPlate(10.0, 10));
  for (const ContactSettings& settings : allFormsAndSurfaces())
  {
    ToolContact contact(*body, settings);
    double last = 10.1;
    for (int i = 0; i <= 600; ++i)
    {
      const double l = 0.005 * i - 1.0;
      const Contact found = contact.update(Vector3(10.0 + l, 5.3, -1.0));
      const double x = std::min(std::max(l, 0.0), 1.0);
      // stored as float32
      EXPECT_NEAR(found.normalForce, 10.0 * (1 - x) * (1 - x) * (1 + 2 * x), 1e-4) << l;
      EXPECT_NEAR(found.force.x(), 0.0, 1e-6); // normals are float32
      EXPECT_NEAR(found.force.y(), 0.0, 1e-6);
      EXPECT_LE(found.normalForce, last + 1e-9);
      last = found.normalForce;
      if (std::abs(l) > 1e-9)
      {
        EXPECT_EQ(found.state, l < 0.0 ? ContactState::Slide : ContactState::LostAtBorder) << l;
      }
      if (l > 1.0)
      {
        EXPECT_EQ(found.force, Vector3::Zero());
        EXPECT_EQ(found.triangle, -1);
      }
    }
  }
}

TEST(BorderContact, OfTheTipsPlaceAlone)
{
  // A tip without an earlier contact has the same force as a tip that slid there.
  const auto body = uniformBody(openPlate(10.0, 10));
  for (const ContactSettings& settings : allFormsAndSurfaces())
  {
    ToolContact out(*body, settings);
    for (const double l : { -0.3, 0.2, 0.5, 0.9, 1.2, 0.7, -0.1 })
    {
      const Vector3 tip(10.0 + l, 5.3, -1.0);
      const Contact found = out.update(tip);
      const Contact fresh = ToolContact(*body, settings).update(tip);
      EXPECT_LE((found.force - fresh.force).norm(), 1e-9) << l;
      EXPECT_EQ(found.state, fresh.state);
    }
  }
}

TEST(BorderContact, FrictionFadesToo)
{
  // With μ = 0.5 friction never exceeds the limit of the faded force while the tip slides out, and
  // the force has no step.
  const auto body = uniformBody(openPlate(10.0, 10));
  ContactSettings settings;
  settings.friction.coefficient = 0.5;
  settings.friction.tangentialStiffness = 20.0;
  ToolContact contact(*body, settings);
  Vector3 last = Vector3::Zero();
  for (int i = 0; i <= 600; ++i)
  {
    const Contact found = contact.update(Vector3(9.0 + 0.005 * i, 5.3, -1.0));
    EXPECT_LE(found.friction.norm(), 0.5 * found.normalForce + 1e-9);
    EXPECT_LE(found.friction.x(), 1e-9); // against the motion
    if (i > 0)
    {
      // The normal force of 10 N changes by at most 1.5 per mm, with 0.005 mm per tick, and
      // friction by half of that; at first friction changes by 20 N/mm.
      EXPECT_LE((found.force - last).norm(), std::hypot(0.075, 0.1) * 1.02) << i;
    }
    last = found.force;
  }
  EXPECT_EQ(last, Vector3::Zero());
}

TEST(BorderContact, BeyondItAnotherBodyIsFound)
{
  // A block next to the plate: the contact with the plate ends where its force has faded to zero,
  // then the contact with the block begins.
  Surface both = openPlate(10.0, 10);
  const Surface other = subdivided(block(10, 10, 10), 3);
  const auto shift = static_cast<std::int32_t>(both.points.size());
  for (const Vector3& p : other.points)
  {
    both.points.push_back(p + Vector3(11.5, 0, -9.0));
  }
  for (const auto& t : other.triangles)
  {
    both.triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
  const auto body = uniformBody(both);
  ToolContact contact(*body);
  EXPECT_EQ(contact.update(Vector3(9.5, 5.3, -1.0)).state, ContactState::Slide);
  EXPECT_EQ(contact.update(Vector3(10.5, 5.3, -1.0)).state, ContactState::LostAtBorder);
  EXPECT_EQ(contact.update(Vector3(11.2, 5.3, -1.0)).force, Vector3::Zero());
  const Contact found = contact.update(Vector3(11.8, 5.3, -1.0));
  EXPECT_EQ(found.state, ContactState::Slide);
  EXPECT_NEAR(found.contactPoint.x(), 11.5, 1e-6);
}
} // namespace palpate::testing
