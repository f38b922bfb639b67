// SPDX-License-Identifier: BSD-3-Clause
#include "SampleResponses.h"
#include "Contact/ToolContact.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

using namespace palpate::testing;
using palpate::Contact;
using palpate::ContactState;
using palpate::ForceForm;
using palpate::NotANumber;
using palpate::ToolContact;
using palpate::Vector3;

namespace
{
void expectNoForce(const Contact& found)
{
  EXPECT_EQ(found.force, Vector3::Zero());
  EXPECT_EQ(found.friction, Vector3::Zero());
  EXPECT_EQ(found.normal, Vector3::Zero());
  EXPECT_EQ(found.contactPoint, Vector3::Zero());
  EXPECT_EQ(found.normalForce, 0.0);
  EXPECT_EQ(found.stiffness, 0.0);
  EXPECT_EQ(found.deflection, 0.0);
  EXPECT_EQ(found.triangle, -1);
}
} // namespace

TEST(ToolContactStates, NumbersOfTheDesign)
{
  EXPECT_EQ(static_cast<int>(ContactState::None), 0);
  EXPECT_EQ(static_cast<int>(ContactState::Stick), 1);
  EXPECT_EQ(static_cast<int>(ContactState::Slide), 2);
  EXPECT_EQ(static_cast<int>(ContactState::BeyondRange), 3);
  EXPECT_EQ(static_cast<int>(ContactState::LostAtBorder), 4);
  EXPECT_EQ(static_cast<int>(ContactState::Invalid), 5);
  EXPECT_EQ(static_cast<int>(ForceForm::Paper), 0);
  EXPECT_EQ(static_cast<int>(ForceForm::NormalizedDirection), 1);
}

TEST(ToolContactStates, NoneOutside)
{
  const auto body = uniformBody(block(40, 40, 10));
  const Contact found = ToolContact(*body).update(Vector3(20, 21, 10.5));
  EXPECT_EQ(found.state, ContactState::None);
  expectNoForce(found);
}

TEST(ToolContactStates, BeyondRange)
{
  // A plate pressed 5 mm deep with curves that end at 2 mm, where F = 10·2^1.5 and K = 15·√2.
  const auto body = uniformBody(subdivided(block(40, 40, 40), 3));
  ToolContact contact(*body);
  EXPECT_EQ(contact.update(Vector3(20.3, 21.1, 38.01)).state, ContactState::Slide);
  const Contact found = contact.update(Vector3(20.3, 21.1, 37.0));
  EXPECT_EQ(found.state, ContactState::BeyondRange);
  // Tolerance: samples are float32.
  EXPECT_NEAR(found.normalForce, 10.0 * std::pow(2.0, 1.5) + 15.0 * std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(found.stiffness, 15.0 * std::sqrt(2.0), 1e-5);
  EXPECT_EQ(contact.update(Vector3(20.3, 21.1, 38.5)).state, ContactState::Slide);
}

TEST(ToolContactStates, BeyondRangeOfOneOfThreeVertices)
{
  const Surface surface = openPlate(10.0, 2);
  ResponseStore store(surface.points.size());
  store.range[4] = 1.0F; // the point in the middle of the plate
  const auto body = contactBody(surface, store);
  EXPECT_EQ(ToolContact(*body).update(Vector3(4.0, 3.0, -1.5)).state, ContactState::BeyondRange);
  EXPECT_EQ(ToolContact(*body).update(Vector3(4.0, 3.0, -0.9)).state, ContactState::Slide);
}

TEST(ToolContactStates, CornersWithoutAShareHaveNoSay)
{
  // The contact is on the edge between (0,0) and (5,5). In either of its two triangles the opposite
  // point has no effect.
  const Surface surface = openPlate(10.0, 2);
  for (const std::size_t opposite : { 1, 3 })
  {
    ResponseStore store(surface.points.size());
    store.range[opposite] = 0.25F;
    const auto shallow = contactBody(surface, store);
    EXPECT_EQ(ToolContact(*shallow).update(Vector3(2.0, 2.0, -0.5)).state, ContactState::Slide);
    store.status[opposite] = 2;
    const auto broken = contactBody(surface, store);
    EXPECT_EQ(ToolContact(*broken).update(Vector3(2.0, 2.0, -0.5)).state, ContactState::Slide);
  }
}

TEST(ToolContactStates, LostAtBorder)
{
  const auto body = uniformBody(openPlate(10.0, 10));
  ToolContact contact(*body);
  EXPECT_EQ(contact.update(Vector3(9.5, 5.2, -0.5)).state, ContactState::Slide);
  const Contact lost = contact.update(Vector3(10.6, 5.2, -0.5));
  EXPECT_EQ(lost.state, ContactState::LostAtBorder);
  expectNoForce(lost);
  EXPECT_EQ(contact.update(Vector3(9.5, 5.2, -0.5)).state, ContactState::Slide);
}

TEST(ToolContactStates, VertexWithoutResponse)
{
  const Surface surface = openPlate(10.0, 10);
  for (const std::uint8_t status : { 1, 2, 3, 4 })
  {
    ResponseStore store(surface.points.size());
    store.status[60] = status; // the point at (5, 5)
    const auto body = contactBody(surface, store);
    ToolContact contact(*body);
    const Contact found = contact.update(Vector3(5.2, 5.1, -0.5));
    EXPECT_EQ(found.state, ContactState::Invalid);
    expectNoForce(found);
    EXPECT_EQ(contact.update(Vector3(7.2, 5.1, -0.5)).state, ContactState::Slide);
  }
  ResponseStore store(surface.points.size());
  store.status[60] = 5; // status Edge: the curve is interpolated and can be used
  const auto body = contactBody(surface, store);
  EXPECT_EQ(ToolContact(*body).update(Vector3(5.2, 5.1, -0.5)).state, ContactState::Slide);
}

TEST(ToolContactStates, TipThatIsNotFinite)
{
  const auto body = uniformBody(subdivided(block(40, 40, 3), 4));
  for (const double bad : { NotANumber, std::numeric_limits<double>::infinity() })
  {
    ToolContact contact(*body);
    EXPECT_GT(contact.update(Vector3(20.3, 18.7, 2.0)).force.z(), 0.0);
    EXPECT_GT(
      // the history keeps the contact at the top
      contact.update(Vector3(20.3, 18.7, 1.2)).force.z(), 0.0);
    const Contact found = contact.update(Vector3(20.3, bad, 1.2));
    EXPECT_EQ(found.state, ContactState::Invalid);
    expectNoForce(found);
    // without the history the nearer side counts
    EXPECT_LT(contact.update(Vector3(20.3, 18.7, 1.2)).force.z(), 0.0);
  }
}

TEST(ToolContactStates, CurvesThatAreNotFinite)
{
  const Surface surface = openPlate(10.0, 10);
  for (const float bad :
    { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity() })
  {
    ResponseStore store(surface.points.size());
    for (std::size_t i = 8 * 60; i < 8 * 61; ++i)
    {
      store.force[i] = bad;
    }
    const auto body = contactBody(surface, store);
    for (const ForceForm form : { ForceForm::Paper, ForceForm::NormalizedDirection })
    {
      const Contact found = ToolContact(*body, { form }).update(Vector3(5.2, 5.1, -0.5));
      EXPECT_EQ(found.state, ContactState::Invalid);
      expectNoForce(found);
    }
  }
}

TEST(ToolContactStates, NormalsThatCancelGiveNoDirection)
{
  const Surface surface = openPlate(10.0, 1);
  ResponseStore store(surface.points.size());
  store.normal.assign(store.normal.size(), 0.0F);
  const auto body = contactBody(surface, store);
  const Contact found = ToolContact(*body).update(Vector3(6.0, 3.0, -0.5));
  EXPECT_EQ(found.state, ContactState::Invalid);
  expectNoForce(found);
}

TEST(ToolContactStates, NormalsThatAreNotFiniteGiveNoDirection)
{
  const Surface surface = openPlate(10.0, 2);
  for (const double wrong : { std::numeric_limits<double>::infinity(), NotANumber })
  {
    ResponseStore store(surface.points.size());
    store.normal.assign(store.normal.size(), static_cast<float>(wrong));
    const auto body = contactBody(surface, store);
    for (const ForceForm form : { ForceForm::Paper, ForceForm::NormalizedDirection })
    {
      palpate::ContactSettings settings;
      settings.form = form;
      const Contact found = ToolContact(*body, settings).update(Vector3(4.0, 3.0, -1.0));
      EXPECT_EQ(found.state, ContactState::Invalid);
      expectNoForce(found);
    }
  }
}

TEST(ToolContactStates, ForeseeingChangesNothing)
{
  // A path over a plate, past its border, beyond the range, outside, and with tips that are not
  // finite or far away.
  const auto body = uniformBody(openPlate(10.0, 20));
  palpate::ContactSettings settings;
  settings.friction.coefficient = 0.5;
  for (const auto surface : { palpate::ContactSurface::Facets, palpate::ContactSurface::Smooth })
  {
    settings.surface = surface;
    ToolContact usual(*body, settings);
    ToolContact foreseeing(*body, settings);
    foreseeing.foresee(); // no tip is known yet
    std::array<int, 6> met{};
    for (int tick = 0; tick < 5000; ++tick)
    {
      const double t = 1e-3 * tick;
      const double z = tick % 97 == 0 ? NotANumber : 1.0 - 4.0 * std::abs(std::sin(5.0 * t));
      const double far = tick % 101 == 0 ? 1e300 : 1.0;
      const Vector3 tip(5.0 + 6.0 * std::sin(3.1 * t), far * (5.0 + 5.5 * std::cos(1.7 * t)), z);
      const Contact expected = usual.update(tip);
      const Contact found = foreseeing.update(tip);
      foreseeing.foresee();
      ASSERT_EQ(found.state, expected.state) << tick;
      ASSERT_EQ(found.force, expected.force) << tick;
      ASSERT_EQ(found.friction, expected.friction) << tick;
      ASSERT_EQ(found.contactPoint, expected.contactPoint) << tick;
      ASSERT_EQ(found.triangle, expected.triangle) << tick;
      ++met[static_cast<std::size_t>(found.state)];
    }
    for (const ContactState state : { ContactState::None, ContactState::Slide,
           ContactState::BeyondRange, ContactState::LostAtBorder, ContactState::Invalid })
    {
      EXPECT_GT(met[static_cast<std::size_t>(state)], 20) << static_cast<int>(state);
    }
  }
}

TEST(ToolContactStates, BodyWithoutTriangles)
{
  const auto body = uniformBody(Surface{});
  const Contact found = ToolContact(*body).update(Vector3::Zero());
  EXPECT_EQ(found.state, ContactState::Invalid);
  expectNoForce(found);
}
