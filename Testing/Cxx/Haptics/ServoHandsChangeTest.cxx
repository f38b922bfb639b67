// SPDX-License-Identifier: BSD-3-Clause
// Two devices on one body. A change of scene has the same interpolation as for one device. A gap in
// one hand's readings does not end its contact. A rehearsal computes the same ticks as the step.
#include "TwoHandStep.h"

#include "SampleBodies.h"
#include "StiffenedBody.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace servo_hands_change
{
using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
constexpr double Endless = std::numeric_limits<double>::infinity();
constexpr double Period = 1e-3; // s
constexpr int RampTicks = 50;   // 50 ms

using Body = std::shared_ptr<const ContactBody>;

std::unique_ptr<ServoScene> sceneOf(
  const Body& body, std::size_t hands = 2, double factor = 1.0, double friction = 0.0)
{
  ContactSettings settings;
  settings.friction.coefficient = friction;
  return std::make_unique<ServoScene>(body, settings, factor, hands);
}

/// All links, for a device that is strong enough for a slab of 10 δ^1.5 N.
SafetySettings whole()
{
  DeviceSpecification device;
  device.maximumForce = 100.0;
  device.maximumStiffness = 50e3;
  return SafetySettings::of(device);
}

TwoHandStep handsOn(const Body& body, const SafetySettings& safety)
{
  return { sceneOf(body), { { {}, safety }, { {}, safety } } };
}

void expectSame(const Tick& one, const Tick& other, int tick)
{
  EXPECT_EQ(one.contact.state, other.contact.state) << tick;
  EXPECT_EQ(one.contact.force, other.contact.force) << tick;
  EXPECT_EQ(one.contact.friction, other.contact.friction) << tick;
  EXPECT_EQ(one.idealForce, other.idealForce) << tick;
  EXPECT_EQ(one.deviceForce, other.deviceForce) << tick;
  EXPECT_EQ(one.forceFactor, other.forceFactor) << tick;
  EXPECT_EQ(one.sceneShare, other.sceneShare) << tick;
  EXPECT_EQ(one.scene, other.scene) << tick;
  EXPECT_EQ(one.acted, other.acted) << tick;
}

int count(std::unique_ptr<ServoScene> list)
{
  int scenes = 0;
  for (; list; list = std::move(list->next))
  {
    ++scenes;
  }
  return scenes;
}

/// A slab of 3 mm. Two hands come from outside and press 1.8 mm deep, beyond its middle.
struct SlabHands
{
  Body slab = stiffened(subdivided(block(40, 40, 3), 4), 1.0F);
  TwoHandStep step = handsOn(this->slab, whole());
  int ticks = 0;

  SlabHands()
  {
    for (int i = 0; i <= 100; ++i)
    {
      this->press(3.2 - 0.02 * i);
    }
  }
  const std::array<Tick, 2>& press(double height, bool isFirstThere = true)
  {
    TwoSamples samples{ sampleOf({}, { 12.3, 18.7, height }),
      sampleOf({}, { 28.3, 18.7, height }) };
    samples[0].valid = isFirstThere;
    return this->step.press(samples, Period * this->ticks++);
  }
  /// Returns whether the force of the top face pushes the hand up.
  bool isOnTop(std::size_t hand) const
  {
    const Contact& contact = this->step.ticks[hand].contact;
    // Rounding of floats.
    return contact.force.z() > 0.0 && std::abs(contact.deflection - 1.8) < 1e-6;
  }
};
} // namespace

// Without coupling, each of two hands has the same bits as a separate step, at every tick of a
// change. The test includes force factors, friction, all links, and a second scene that waits.
TEST(ServoHandsChange, EachOfTwoHasTheBlendOfOne)
{
  const CoupledPlate plate;
  const Body ball = plate.body(false);
  const Body flat = CoupledPlate(true).body(false);
  const SafetySettings safety = whole();
  TwoHandStep hands = handsOn(ball, safety);
  ServoStep first(sceneOf(ball, 1), {}, safety);
  ServoStep second(sceneOf(ball, 1), {}, safety);
  int blended = 0;
  for (int tick = 0; tick < 600; ++tick)
  {
    const double time = Period * tick;
    const double depth = std::min(0.02 * (tick - 30), 0.7);
    const TwoSamples samples{ sampleOf({}, { 25.0 + 2.0 * time, 29.3, -depth }),
      sampleOf({}, { 33.0, 29.3 - 3.0 * time, -0.8 * depth }) };
    if (tick == 200 || tick == 220 || tick == 400)
    {
      const Body& next = tick == 220 ? ball : flat;
      EXPECT_TRUE(hands.change(sceneOf(next, 2, 0.5, 0.3)));
      EXPECT_TRUE(first.change(sceneOf(next, 1, 0.5, 0.3)));
      EXPECT_TRUE(second.change(sceneOf(next, 1, 0.5, 0.3)));
    }
    const auto& both = hands.press(samples, time);
    expectSame(both[0], first.step(samples[0], time), tick);
    expectSame(both[1], second.step(samples[1], time), tick);
    EXPECT_EQ(hands.isSwitching(), first.isSwitching());
    blended += both[0].sceneShare < 1.0 && both[1].deviceForce.z() > 0.0;
  }
  EXPECT_GE(blended, 3 * (RampTicks - 1));
  EXPECT_EQ(hands.ticks[1].scene, 3U);
  EXPECT_EQ(count(hands.takeRetired()), 3);
}

// Two coupled flat ends at rest, then the same springs without coupling: each force is the linear
// interpolation between both states.
TEST(ServoHandsChange, CoupledForcesGoOverLinearly)
{
  const CoupledPlate plate(true);
  const Body coupling = plate.body(true);
  const Body apart = plate.body(false);
  TwoHandStep hands = handsOn(coupling, SafetySettings::magnitudeOnly(Endless));
  const TwoSamples samples = FlatEnds::pressing(0.5, 0.8);
  int tick = 0;
  for (; tick < 50; ++tick)
  {
    hands.press(samples, Period * tick);
  }
  const std::array<double, 2> coupled{ FlatEnds::force(0.5, 0.8), FlatEnds::force(0.8, 0.5) };
  const std::array<double, 2> alone{ 0.5 * FlatEnds::Spring, 0.8 * FlatEnds::Spring };
  EXPECT_TRUE(hands.change(sceneOf(apart)));
  for (int i = 0; i < 2 * RampTicks; ++i, ++tick)
  {
    const double way = std::min(1.0, static_cast<double>(i) / RampTicks);
    hands.press(samples, Period * tick);
    for (std::size_t hand = 0; hand < 2; ++hand)
    {
      EXPECT_NEAR(hands.ticks[hand].deviceForce.z(),
        (1.0 - way) * coupled[hand] + way * alone[hand], 1e-5) // rounding of floats
        << i << ", hand " << hand;
    }
  }
  EXPECT_FALSE(hands.isSwitching());
}

TEST(ServoHandsChange, ASceneForAnotherNumberOfHandsIsRefused)
{
  const Body body = CoupledPlate(true).body();
  TwoHandStep hands = handsOn(body, SafetySettings::magnitudeOnly(Endless));
  EXPECT_FALSE(hands.change(nullptr));
  EXPECT_FALSE(hands.change(sceneOf(body, 1)));
  EXPECT_FALSE(hands.isSwitching());
  EXPECT_EQ(count(hands.takeRetired()), 1);
  // The constructor adapts the scene to the number of hands, and ignores a fifth hand.
  const SafetySettings safety = whole();
  const ServoStep::Hand hand{ {}, safety };
  EXPECT_EQ(ServoStep(sceneOf(body, 2), { hand, hand, hand }).count(), 3U);
  EXPECT_EQ(ServoStep(sceneOf(body, 1), { hand, hand, hand, hand, hand }).count(), 4U);
}

// After a gap in its readings, a hand beyond the middle of a slab is still on the side from which
// it came. After a loss it is not.
TEST(ServoHandsChange, AGapOfOneKeepsItsContact)
{
  SlabHands hands;
  EXPECT_TRUE(hands.isOnTop(0) && hands.isOnTop(1));
  for (int i = 0; i < 15; ++i)
  {
    hands.press(1.2, false);
    EXPECT_EQ(hands.step.ticks[0].deviceForce, Vector3d::Zero());
    EXPECT_TRUE(hands.isOnTop(1));
    EXPECT_GT(hands.step.ticks[1].deviceForce.z(), 0.0);
  }
  hands.press(1.2);
  EXPECT_TRUE(hands.isOnTop(0));
  EXPECT_EQ(hands.step.ticks[0].acted & static_cast<std::uint16_t>(SafetyLink::Gate), 0);
  for (int i = 0; i < 25; ++i) // 20 ms is the time-out
  {
    hands.press(1.2, false);
  }
  hands.press(1.2);
  hands.press(1.2);
  EXPECT_LT(hands.step.ticks[0].contact.force.z(), 0.0);
  EXPECT_TRUE(hands.isOnTop(1));
  EXPECT_NE(hands.step.ticks[0].acted & static_cast<std::uint16_t>(SafetyLink::Gate), 0);
}

// The scene changes during the gap. The new contact of the hand begins on the same side when the
// readings return.
TEST(ServoHandsChange, AGapAcrossAChangeKeepsTheSide)
{
  SlabHands hands;
  hands.press(1.2, false);
  EXPECT_TRUE(hands.step.change(sceneOf(hands.slab)));
  for (int i = 0; i < 15; ++i)
  {
    hands.press(1.2, false);
    EXPECT_TRUE(hands.isOnTop(1));
  }
  EXPECT_TRUE(hands.step.isSwitching());
  for (int i = 0; i < 2 * RampTicks; ++i)
  {
    hands.press(1.2);
    EXPECT_TRUE(hands.isOnTop(0) && hands.isOnTop(1)) << i;
  }
  EXPECT_FALSE(hands.step.isSwitching());
}

// The ramp belongs to the scene. It continues while one hand is lost, and ends when all hands are
// lost.
TEST(ServoHandsChange, ARampEndsWhenAllAreLost)
{
  SlabHands hands;
  EXPECT_TRUE(hands.step.change(sceneOf(hands.slab)));
  hands.press(1.2);
  hands.step.stop(0);
  hands.press(1.2);
  EXPECT_TRUE(hands.step.isSwitching());
  EXPECT_EQ(hands.step.ticks[0].deviceForce, Vector3d::Zero());
  EXPECT_GT(hands.step.ticks[1].deviceForce.z(), 0.0);
  hands.step.stop(1);
  hands.press(1.2);
  EXPECT_FALSE(hands.step.isSwitching());
  EXPECT_EQ(hands.step.ticks[1].deviceForce, Vector3d::Zero());
  hands.step.start();
  hands.press(3.2);
  hands.press(2.9);
  EXPECT_GT(hands.step.ticks[0].deviceForce.z(), 0.0);
  EXPECT_GT(hands.step.ticks[1].deviceForce.z(), 0.0);
}

// A rehearsal of the samples that the step gets computes the same bits, and does not change the
// state.
TEST(ServoHandsChange, ARehearsalOfTwoIsForgotten)
{
  const Body body = CoupledPlate().body();
  TwoHandStep rehearsed(sceneOf(body, 2, 1.0, 0.4), { { {}, whole(), 1 }, { {}, whole() } });
  TwoHandStep plain(sceneOf(body, 2, 1.0, 0.4), { { {}, whole(), 1 }, { {}, whole() } });
  std::array<Tick, 2> likely;
  int pressed = 0;
  for (int tick = 0; tick < 2000; ++tick)
  {
    const double t = Period * tick;
    TwoSamples samples{ sampleOf({}, { 25.0 + 5.0 * t, 29.3, 0.2 - std::abs(std::sin(6.0 * t)) }),
      sampleOf({}, { 31.0, 29.3 - 2.0 * t, 0.2 - std::abs(std::sin(5.0 * t)) }) };
    samples[0].buttons = tick / 300 % 4 == 2 ? 1 : 0;
    samples[1].valid = tick % 201 > 3;
    TwoSamples others = FlatEnds::pressing(0.3, tick % 5 - 2.0);
    others[0].valid = tick % 17 != 0;
    rehearsed.rehearse(others.data(), t, likely.data());
    rehearsed.rehearse(samples.data(), t, likely.data());
    rehearsed.press(samples, t);
    plain.press(samples, t);
    for (std::size_t hand = 0; hand < 2; ++hand)
    {
      expectSame(likely[hand], plain.ticks[hand], tick);
      expectSame(rehearsed.ticks[hand], plain.ticks[hand], tick);
      EXPECT_EQ(rehearsed.energy(hand), plain.energy(hand));
    }
    pressed += plain.ticks[0].deviceForce.z() > 0.0 && plain.ticks[1].deviceForce.z() > 0.0;
  }
  EXPECT_GT(pressed, 300);
}
} // namespace servo_hands_change
