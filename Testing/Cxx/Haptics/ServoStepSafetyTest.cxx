// SPDX-License-Identifier: BSD-3-Clause
// The step with chain, clutch and switch: the force that is sent to the device, and the cases
// without force.
#include "Haptics/Servo/ServoStep.h"

#include "SampleResponses.h"
#include "StiffenedBody.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace servo_step_safety
{
using Eigen::Vector3d;
using namespace palpate;
using palpate::Infinity;
using palpate::NotANumber;
using namespace palpate::testing;

namespace
{
constexpr double Period = 1e-3; // s
constexpr std::uint32_t Button = 4;

Surface thinSlab()
{
  return subdivided(block(40, 40, 3), 4);
}

DeviceSample sampleAt(const Vector3d& metres, std::uint32_t buttons = 0)
{
  DeviceSample sample;
  sample.position = metres;
  sample.buttons = buttons;
  sample.valid = true;
  return sample;
}

/// A sample over the middle of the slab, in m at scale 1.
DeviceSample overSlab(double height, std::uint32_t buttons = 0)
{
  return sampleAt(1e-3 * Vector3d(20.3, 18.7, height), buttons);
}

std::unique_ptr<ServoScene> slabScene(float factor = 1.0F)
{
  return std::make_unique<ServoScene>(stiffened(thinSlab(), factor));
}

SafetySettings unlimited()
{
  return SafetySettings::magnitudeOnly(Infinity);
}

/// All links, for a device that is strong enough for a slab of 10 δ^1.5 N.
SafetySettings whole()
{
  DeviceSpecification device;
  device.maximumForce = 100.0;
  device.maximumStiffness = 50e3;
  return SafetySettings::of(device);
}

/// A step whose tip has come from outside and presses 1.8 mm deep, beyond the middle of the slab.
struct Pressed
{
  ServoStep step;
  double time = 0.0;
  Tick last;

  explicit Pressed(const SafetySettings& safety, std::uint32_t clutch = 0)
    : step(slabScene(), WorkspaceMapping(), safety, clutch)
  {
    for (int i = 0; i <= 100; ++i)
    {
      this->go(overSlab(3.2 - 0.02 * i));
    }
  }
  const Tick& go(const DeviceSample& sample)
  {
    this->last = this->step.step(sample, this->time);
    this->time += Period;
    return this->last;
  }
};
} // namespace

TEST(ServoStepSafety, TheFormerStepGivesTheFormerBits)
{
  // Without a chain the factor is the limit divided by the norm, in the frame of the body.
  const auto body = uniformBody(icosphere(20.0, 3));
  const double limit = 3.0;
  ServoStep step(*body, WorkspaceMapping(), limit);
  ToolContact contact(*body);
  int limited = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3d tip = (20.0 - 0.9 * std::abs(std::sin(0.01 * i))) *
      Vector3d(std::cos(0.003 * i), std::sin(0.003 * i), 0.4).normalized();
    const DeviceSample sample = sampleAt(1e-3 * tip);
    const Tick tick = step.step(sample, 0.0); // the time is not used
    const Vector3d force = contact.update(WorkspaceMapping().toBody(sample.position)).force;
    const double magnitude = force.norm();
    const double share = magnitude > limit ? limit / magnitude : 1.0;
    ASSERT_EQ(tick.deviceForce, share * force) << i;
    EXPECT_EQ(tick.contact.force, force);
    EXPECT_EQ(tick.idealForce, force);
    EXPECT_EQ(tick.appliedForce, tick.deviceForce);
    EXPECT_EQ(tick.acted, share < 1.0 ? static_cast<int>(SafetyLink::Magnitude) : 0);
    limited += share < 1.0;
  }
  EXPECT_GT(limited, 300);
  EXPECT_LT(limited, 900);
}

TEST(ServoStepSafety, TheTickTellsWhatCameInAndWhatWentOut)
{
  const WorkspaceMapping mapping(
    Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix(), Vector3d(5, -3, 2),
    2.0);
  SafetySettings safety = unlimited();
  safety.forceFactor = 0.5;
  auto scene = std::make_unique<ServoScene>(
    std::shared_ptr<const ContactBody>(uniformBody(thinSlab())), ContactSettings(), 0.4);
  ServoStep step(std::move(scene), mapping, safety);
  DeviceSample sample = sampleAt(mapping.toDevice(Vector3d(20.3, 18.7, 2.5)), 9);
  sample.velocity = Vector3d(0.1, -0.2, 0.3);
  sample.fresh = false;
  const Tick tick = step.step(sample, 0.25);
  EXPECT_EQ(tick.time, 0.25);
  EXPECT_TRUE(tick.valid);
  EXPECT_FALSE(tick.fresh || tick.clutched);
  EXPECT_EQ(tick.buttons, 9U);
  EXPECT_EQ(tick.velocity, mapping.velocityToBody(sample.velocity));
  EXPECT_EQ(tick.idealForce, tick.contact.force);
  EXPECT_NEAR(tick.forceFactor, 0.5 * 0.4, 1e-16); // factor of the session times factor of the
                                                   // scene
  EXPECT_LE((tick.appliedForce - 0.2 * tick.idealForce).norm(), 1e-14);
  EXPECT_LE((mapping.forceToDevice(tick.appliedForce) - tick.deviceForce).norm(), 1e-14);
  EXPECT_EQ(tick.acted, static_cast<int>(SafetyLink::Fit));
  EXPECT_EQ(tick.scene, 0U);
  EXPECT_EQ(step.safety().forceFactor, 0.5);
  EXPECT_EQ(step.mapping().scale(), 2.0);
}

TEST(ServoStepSafety, NothingIsSentInTheTickOfAFailureAndContactsAreForgotten)
{
  DeviceSample gone = overSlab(1.2);
  gone.valid = false;
  DeviceSample wrong = overSlab(1.2);
  wrong.position.y() = NotANumber;
  SafetySettings gated = whole();
  gated.controlPassivity = false; // without passivity control there are no gaps
  for (const SafetySettings& safety : { gated, unlimited() })
  {
    for (const DeviceSample& bad : { gone, wrong, DeviceSample(), sampleAt(Vector3d(0, 0, 1e306)) })
    {
      Pressed pressed(safety);
      EXPECT_GT(pressed.last.deviceForce.z(), 5.0);
      pressed.step.change(slabScene(2.0F));
      pressed.go(overSlab(1.2));
      EXPECT_GT(pressed.go(overSlab(1.2)).deviceForce.z(), 5.0);
      EXPECT_TRUE(pressed.step.isSwitching());

      pressed.go(bad);
      EXPECT_EQ(pressed.last.deviceForce, Vector3d::Zero());
      EXPECT_EQ(pressed.last.appliedForce, Vector3d::Zero());
      EXPECT_EQ(pressed.last.contact.state, ContactState::Invalid);
      EXPECT_FALSE(pressed.last.valid || pressed.last.fresh);
      EXPECT_NE(pressed.last.acted & static_cast<int>(SafetyLink::NoSample), 0);
      EXPECT_FALSE(pressed.step.isSwitching()) << "nothing is left to ramp";
      EXPECT_NE(pressed.step.takeRetired(), nullptr);
      // The same tip now belongs to the bottom. With a gate, the tip must first have been outside.
      pressed.go(overSlab(1.2));
      EXPECT_LT(pressed.last.contact.force.z(), 0.0);
      EXPECT_EQ(pressed.last.deviceForce == Vector3d::Zero(), safety.gate);
    }
  }
}

TEST(ServoStepSafety, AMissingReadingCostsItsTickAndNotTheTouch)
{
  DeviceSample gone = overSlab(1.2);
  gone.valid = false;
  DeviceSample wrong = overSlab(1.2);
  wrong.position.y() = NotANumber;
  for (const DeviceSample& bad : { gone, wrong, DeviceSample(), sampleAt(Vector3d(0, 0, 1e306)) })
  {
    Pressed pressed(whole());
    const double before = pressed.last.deviceForce.z();
    EXPECT_GT(before, 5.0);
    EXPECT_EQ(pressed.go(bad).deviceForce, Vector3d::Zero());
    EXPECT_EQ(pressed.last.contact.state, ContactState::Invalid);
    EXPECT_FALSE(pressed.last.valid || pressed.last.fresh);
    EXPECT_NE(pressed.last.acted & static_cast<int>(SafetyLink::NoSample), 0);
    // The contact is still on the side where the tip entered, although the bottom is nearer.
    EXPECT_NEAR(pressed.go(overSlab(1.2)).deviceForce.z(), before, 1e-9);
  }
}

TEST(ServoStepSafety, ASilentDeviceIsSentNothingFromTheTickItCountsAsLost)
{
  Pressed pressed(whole()); // the time-out is 20 ms
  DeviceSample silent = overSlab(1.2);
  silent.fresh = false;
  int sent = 0;
  while (pressed.go(silent).deviceForce.z() > 0.0 && sent < 100)
  {
    ++sent;
  }
  EXPECT_NEAR(sent, 20, 1); // ticks of 1 ms; the tick at 20 ms depends on rounding
  EXPECT_EQ(pressed.last.deviceForce, Vector3d::Zero());
  EXPECT_EQ(pressed.last.acted, static_cast<int>(SafetyLink::Watchdog));
  EXPECT_GT(pressed.last.contact.force.z(), 0.0); // the contact ends after this tick
  EXPECT_LT(pressed.go(overSlab(1.2)).contact.force.z(), 0.0);
  EXPECT_EQ(pressed.last.deviceForce, Vector3d::Zero()) << "back, but the gate is shut";
}

TEST(ServoStepSafety, StoppedNothingIsSentUntilStart)
{
  Pressed pressed(unlimited());
  pressed.step.stop();
  EXPECT_EQ(pressed.go(overSlab(2.0)).deviceForce, Vector3d::Zero());
  EXPECT_EQ(pressed.last.acted, static_cast<int>(SafetyLink::Stopped));
  pressed.step.reset();
  EXPECT_EQ(pressed.go(overSlab(2.0)).deviceForce, Vector3d::Zero());
  pressed.step.start();
  EXPECT_GT(pressed.go(overSlab(2.0)).deviceForce.z(), 5.0);
}

TEST(ServoStepSafety, AMappingWithAFaultSendsNothing)
{
  const WorkspaceMapping wrong(2.0 * Eigen::Matrix3d::Identity(), Vector3d::Zero(), 1.0);
  ServoStep step(slabScene(), wrong, unlimited());
  const Tick tick = step.step(sampleAt(1e-3 * Vector3d(10, 9, 1.2)), 0.0);
  EXPECT_FALSE(tick.valid);
  EXPECT_EQ(tick.deviceForce, Vector3d::Zero());
}

TEST(ServoStepSafety, NoStifferThanTheDeviceAllowsAtAnyScaleAndFactor)
{
  for (const double scale : { 0.5, 1.0, 3.0 })
  {
    for (const double factor : { 1.0, 0.3 })
    {
      SafetySettings safety = unlimited();
      safety.capStiffness = true;
      safety.maximumStiffness = 3000.0; // N/m
      safety.forceFactor = factor;
      const WorkspaceMapping mapping(Eigen::Matrix3d::Identity(), Vector3d::Zero(), scale);
      ServoStep step(slabScene(3.0F), mapping, safety); // the stiffness is 45 √δ N/mm
      const double way = 1e-6;                          // m
      double last = 0.0;
      double stiffest = 0.0;
      double uncapped = 0.0;
      double felt = 0.0;
      for (double depth = 0.0; depth < 1.4; depth += 1e3 * scale * way)
      {
        const Tick tick =
          step.step(sampleAt(mapping.toDevice(Vector3d(20.3, 18.7, 3.0 - depth))), 0.0);
        stiffest = std::max(stiffest, (tick.deviceForce.z() - last) / way);
        uncapped = std::max(uncapped, (tick.idealForce.z() * factor - felt) / way);
        last = tick.deviceForce.z();
        felt = tick.idealForce.z() * factor;
      }
      // The tolerance of the cap is 1e-7 of K δ, over steps of δ/1000. The tolerance of the float32
      // mesh is 1e-6 mm of 1e-3 mm.
      EXPECT_LE(stiffest, 3000.0 * 1.003) << scale;
      EXPECT_GE(stiffest, 3000.0 * 0.99) << scale;
      EXPECT_GT(uncapped, 2.0 * stiffest);
    }
  }
}

TEST(ServoStepSafety, ThePassivityControlLeavesAPassiveSceneAlone)
{
  // A spring much softer than the device allows is pressed and released, and slid back and forth
  // with friction. Its energy, which follows from δ and the stretch of the friction, exceeds F²/(2
  // K_max).
  ContactSettings settings;
  settings.friction.coefficient = 0.5;
  settings.friction.tangentialStiffness = 2.0;
  for (const ContactSettings& each : { ContactSettings(), settings })
  {
    ServoStep step(
      std::make_unique<ServoScene>(stiffened(thinSlab(), 0.1F), each), WorkspaceMapping(), whole());
    int touching = 0;
    for (int i = 0; i < 2000; ++i)
    {
      const double t = Period * i;
      const double slide = each.friction.coefficient > 0.0 ? 0.5 * std::sin(9.0 * t) : 0.0;
      const Vector3d tip(20.3 + slide, 18.7, 3.1 - 1.2 * std::abs(std::sin(4.0 * t)));
      const Tick tick = step.step(sampleAt(1e-3 * tip), t);
      ASSERT_EQ(tick.acted, 0) << i;
      EXPECT_EQ(tick.deviceForce, tick.contact.force);
      touching += tick.contact.normalForce > 0.0;
    }
    EXPECT_GT(touching, 1500);
  }
}

TEST(ServoStepSafety, APlanarDeviceFeelsWhatLiesInItsPlane)
{
  // The device moves along the body's x (its x) and z (its y), in the plane y = 18.7.
  const WorkspaceMapping mapping =
    WorkspaceMapping::inPlane(Vector3d(20.3, 18.7, 0), Vector3d::UnitX(), Vector3d::UnitZ(), 1.0);
  ContactSettings settings;
  settings.friction.coefficient = 0.5;
  auto scene = std::make_unique<ServoScene>(
    std::shared_ptr<const ContactBody>(uniformBody(icosphere(30.0, 3))), settings);
  ServoStep step(std::move(scene), mapping, unlimited());
  for (int i = 0; i < 50; ++i)
  {
    const Tick tick = step.step(sampleAt(Vector3d(-1e-5 * i, 0.0105, NotANumber)), 1e-3 * i);
    ASSERT_TRUE(tick.valid);
    EXPECT_EQ(tick.tip.y(), 18.7);
    EXPECT_GT(std::abs(tick.contact.force.y()), 1.0) << "the body pushes out of the plane as well";
    EXPECT_EQ(tick.deviceForce.z(), 0.0);
    EXPECT_EQ(tick.appliedForce.y(), 0.0);
    EXPECT_NEAR(tick.deviceForce.x(), tick.contact.force.x(), 1e-15);
    EXPECT_NEAR(tick.deviceForce.y(), tick.contact.force.z(), 1e-15);
  }
}

TEST(ServoStepSafety, ClutchedTheHandIsFreeAndNothingJumps)
{
  for (const bool controlled : { true, false })
  {
    Pressed pressed(controlled ? whole() : unlimited(), Button);
    const double full = pressed.last.deviceForce.z();
    EXPECT_GT(full, 5.0);
    const Vector3d tip = pressed.last.tip;
    double last = full;
    // While the button is held, the hand moves up by 20 mm. After the release it stands still. With
    // passivity control the hand waits until the force is zero, because motion along the force
    // would cause the control to reduce the force earlier.
    const int wait = controlled ? 60 : 1;
    for (int i = 1; i <= 500; ++i)
    {
      const bool held = i <= 300;
      const double height = 1.2 + 0.1 * std::clamp(i - wait, 0, 200);
      pressed.go(overSlab(height, held ? Button : 0));
      EXPECT_EQ(pressed.last.clutched, held);
      EXPECT_LE((pressed.last.tip - tip).norm(), 1e-12); // rounding error for positions of 40 mm
      EXPECT_LE(std::abs(pressed.last.deviceForce.z() - last), full * Period / 0.05 + 1e-9) << i;
      EXPECT_NEAR(pressed.last.contact.force.z(), full, 1e-9) << "the tip feels what it felt";
      last = pressed.last.deviceForce.z();
      if (i > 51 && held)
      {
        EXPECT_EQ(pressed.last.deviceForce, Vector3d::Zero());
      }
    }
    EXPECT_NEAR(last, full, 1e-9);
    // The tip continues from its position: 1.8 mm up it is outside, although the hand is 20 mm
    // higher than initially.
    EXPECT_GT(pressed.go(overSlab(21.2 + 1.7)).contact.force.z(), 0.0);
    EXPECT_EQ(pressed.go(overSlab(21.2 + 1.9)).contact.state, ContactState::None);
  }
}

TEST(ServoStepSafety, TheClutchDoesNotOpenTheGate)
{
  ServoStep step(slabScene(), WorkspaceMapping(), whole(), Button);
  double time = 0.0;
  // Begins inside; the hand moves outside, but the tip does not.
  for (int i = 0; i < 300; ++i, time += Period)
  {
    const bool held = i > 50 && i < 200;
    const Tick tick =
      step.step(overSlab(2.0 + 0.05 * std::clamp(i - 51, 0, 148), held ? Button : 0), time);
    EXPECT_GT(tick.contact.force.z(), 5.0);
    EXPECT_EQ(tick.deviceForce, Vector3d::Zero()) << i;
  }
  // The tip moves out and in again.
  EXPECT_EQ(step.step(overSlab(11.0), time).contact.state, ContactState::None);
  for (int i = 0; i < 50; ++i)
  {
    step.step(overSlab(11.0 - 0.05 * i), time += Period);
  }
  EXPECT_GT(step.step(overSlab(8.5), time += Period).deviceForce.z(), 0.0);
}

TEST(ServoStepSafety, AScenesChangeReachesTheDeviceWithoutAStep)
{
  // All links on, at rest. The force at 1.8 mm changes from 10 δ^1.5 N to 30 δ^1.5 N within 50 ms.
  Pressed pressed(whole());
  const double before = pressed.last.deviceForce.z();
  pressed.step.change(slabScene(2.0F));
  double last = before;
  for (int i = 0; i <= 60; ++i)
  {
    pressed.go(overSlab(1.2));
    EXPECT_LE(std::abs(pressed.last.deviceForce.z() - last), before * Period / 0.05 + 1e-6) << i;
    EXPECT_EQ(pressed.last.acted, 0);
    EXPECT_EQ(pressed.last.scene, 1U);
    last = pressed.last.deviceForce.z();
  }
  EXPECT_NEAR(last, 2.0 * before, 1e-5); // curves are stored as float32
  EXPECT_EQ(pressed.last.sceneShare, 1.0);
}

TEST(ServoStepSafety, ACopyGoesItsOwnWay)
{
  Pressed pressed(unlimited());
  pressed.step.change(slabScene(2.0F));
  pressed.go(overSlab(1.2));
  ServoStep copy = pressed.step;
  for (int i = 0; i < 20; ++i, pressed.time += Period)
  {
    const DeviceSample sample = overSlab(1.2 + 0.01 * i);
    EXPECT_EQ(copy.step(sample, pressed.time).deviceForce,
      pressed.step.step(sample, pressed.time).deviceForce);
  }
  pressed.step.reset();
  EXPECT_TRUE(copy.isSwitching());
  EXPECT_GT(copy.step(overSlab(1.2), pressed.time).contact.force.z(), 0.0);
  EXPECT_LT(pressed.step.step(overSlab(1.2), pressed.time).contact.force.z(), 0.0);
  ServoStep moved = std::move(copy);
  EXPECT_TRUE(moved.isSwitching());
}
} // namespace servo_step_safety
