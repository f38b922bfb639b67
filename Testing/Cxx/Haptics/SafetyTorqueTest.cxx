// SPDX-License-Identifier: BSD-3-Clause
// The chain with a torque: the gate and the factor of the force, separate limits, and no torque
// whenever there is no force.
#include "Haptics/Safety/SafetyChain.h"

#include "ChainedWall.h"

#include "Haptics/Servo/SceneSwitch.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace safety_torque
{
using Eigen::Vector3d;
using namespace palpate;
using palpate::Infinity;
using palpate::NotANumber;
using namespace palpate::testing;

namespace
{
SafetySettings turning()
{
  DeviceSpecification device;
  device.outputsTorque = true;
  device.maximumTorque = 0.2;
  device.maximumTorsionalStiffness = 1.0;
  return SafetySettings::of(device);
}

/// A wall that also turns the tool upright, by 40 mN m/rad at a depth of 1 mm and less at smaller
/// depths. This torque is small enough to be passive in addition to the force.
struct TurningWall : ChainedWall
{
  using ChainedWall::ChainedWall;

  SafetyInput at(double depth, double tilt)
  {
    SafetyInput input = this->ChainedWall::at(depth);
    input.orientation = turnedBy(Vector3d(tilt, 0.0, 0.0));
    input.idealTorque.x() = -40.0 * std::max(0.0, depth) * tilt;
    input.cappedTorque = input.idealTorque;
    return input;
  }
  /// Tilts the tool by 0.1 rad outside, then presses it 1 mm deep.
  SafeForce press()
  {
    SafeForce last;
    for (int i = -10; i <= 20; ++i)
    {
      last = this->Chain.apply(this->at(5e-5 * i, 0.1));
    }
    return last;
  }
};
} // namespace

TEST(SafetyTorque, PassesWhatNeedsNothing)
{
  TurningWall wall(turning());
  for (int i = -10; i <= 20; ++i)
  {
    const SafetyInput input = wall.at(5e-5 * i, 0.1 + 1e-3 * i);
    const SafeForce safe = wall.Chain.apply(input);
    EXPECT_EQ(safe.force, input.idealForce);
    EXPECT_EQ(safe.torque, input.idealTorque);
    EXPECT_EQ(safe.acted, 0) << i;
  }
}

TEST(SafetyTorque, GoesWithTheForceInTheSameTick)
{
  const auto expectNone = [](const SafeForce& safe, SafetyLink link)
  {
    EXPECT_EQ(safe.force, Vector3d::Zero());
    EXPECT_EQ(safe.torque, Vector3d::Zero());
    EXPECT_TRUE(safe.has(link)) << safe.acted;
  };
  TurningWall wall(turning());
  expectNone(wall.Chain.apply(wall.at(1e-3, 0.1)), SafetyLink::Gate);
  EXPECT_LT(wall.press().torque.x(), -0.0039);

  SafetyInput input = wall.at(1e-3, 0.1);
  input.valid = false;
  expectNone(wall.Chain.apply(input), SafetyLink::NoSample);          // a gap
  EXPECT_LT(wall.Chain.apply(wall.at(1e-3, 0.1)).torque.x(), -0.001); // the value after the gap
  input = wall.at(1e-3, 0.1);
  input.orientation.x() = NotANumber;
  expectNone(wall.Chain.apply(input), SafetyLink::NoSample);
  wall.press();
  input = wall.at(1e-3, 0.1);
  input.idealTorque.z() = NotANumber;
  expectNone(wall.Chain.apply(input), SafetyLink::NotFinite);
  expectNone(wall.Chain.apply(wall.at(1e-3, 0.1)), SafetyLink::Gate);
  wall.press();
  wall.Time += 0.1; // no reading for a long time
  expectNone(wall.Chain.apply(wall.at(1e-3, 0.1)), SafetyLink::Watchdog);
  wall.press();
  wall.Chain.stop();
  expectNone(wall.Chain.apply(wall.at(1e-3, 0.1)), SafetyLink::Stopped);
  wall.Chain.start();
  // Energy of a turn that is not reported cannot be counted.
  wall.press();
  input = wall.at(1e-3, 0.1);
  input.orientation = orientationNotTold();
  const SafeForce untold = wall.Chain.apply(input);
  EXPECT_GT(untold.force.z(), 0.9);
  EXPECT_EQ(untold.torque, Vector3d::Zero());
}

TEST(SafetyTorque, LimitsOfItsOwn)
{
  SafetySettings settings = turning();
  settings.controlPassivity = false;
  settings.forceFactor = 0.5;
  settings.maximumTorqueRate = 40.0; // 0.04 N m per tick
  ChainedWall wall(settings);
  wall.Chain.apply(wall.at(0.0));
  SafetyInput input = wall.at(1e-3);
  input.orientation = ToolOrientation::Identity();
  input.idealTorque.y() = 1.0;
  input.cappedTorque.y() = 0.8; // capped to 0.8 of the requested torque
  const std::uint16_t always = flag(SafetyLink::Fit) + flag(SafetyLink::StiffnessCap);
  for (const double expected : { 0.04, 0.08, 0.12, 0.16, 0.2, 0.2 })
  {
    const SafeForce safe = wall.Chain.apply(input);
    // Times of 1e-3 s are rounded to 2e-15 s after 10 s.
    EXPECT_NEAR(safe.torque.y(), expected, 1e-12);
    EXPECT_EQ(safe.force.z(), 0.5);
    EXPECT_EQ(safe.acted & (always | flag(SafetyLink::Slew)), always | flag(SafetyLink::Slew));
    input.time += Period;
  }
  // The rate limit starts from the sent 0.2 N m, so the limit of the magnitude does not influence
  // it.
  input.cappedTorque.setZero();
  EXPECT_NEAR(wall.Chain.apply(input).torque.y(), 0.16, 1e-12);

  settings.maximumTorqueRate = Infinity;
  ChainedWall clamped(settings);
  clamped.Chain.apply(clamped.at(0.0));
  input = clamped.at(1e-3);
  input.orientation = ToolOrientation::Identity();
  input.idealTorque = input.cappedTorque = Vector3d(0.6, 0.0, -0.8);
  const SafeForce safe = clamped.Chain.apply(input);
  EXPECT_LE((safe.torque - Vector3d(0.12, 0.0, -0.16)).norm(), 1e-16);
  EXPECT_TRUE(safe.has(SafetyLink::Magnitude));
  EXPECT_EQ(safe.force.z(), 0.5);
}

TEST(SafetyTorque, ADeviceWithoutTorqueIsSentTheForceOfBefore)
{
  // Turns, torques and invalid values change no bit if no torque is sent.
  TurningWall turned(whole());
  ChainedWall plain(whole());
  for (int i = -10; i <= 60; ++i)
  {
    const double depth = 1e-4 * (i > 40 ? 80 - i : i);
    SafetyInput input = turned.at(depth, 0.3 * std::sin(i));
    input.idealTorque.z() = i % 7 == 0 ? NotANumber : 1.0;
    const SafeForce a = turned.Chain.apply(input);
    const SafeForce b = plain.feel(depth);
    ASSERT_EQ(a.force, b.force);
    ASSERT_EQ(a.torque, Vector3d::Zero());
    ASSERT_EQ(a.acted, b.acted);
    ASSERT_EQ(a.holdTime, b.holdTime);
    ASSERT_EQ(turned.Chain.energy(), plain.Chain.energy());
  }
}

TEST(SafetyTorque, AHandThatTurnsAtDepthGetsNoMoreThanItPutIn)
{
  // A flat end that is pressed in while tilted has a small force. Turned upright at depth, it has a
  // large force. The device outputs no torque, so the turn needs no work of the hand. The energy of
  // the force must have been put in.
  SafetySettings settings = whole();
  ChainedWall wall(settings);
  double given = 0.0;
  double damping = 0.0;
  double last = 0.0;
  double lastForce = 0.0;
  for (int loop = 0; loop < 5; ++loop)
  {
    for (int i = -5; i <= 80; ++i)
    {
      const double depth = 1e-4 * (i <= 40 ? i : 80 - i);
      SafetyInput input = wall.at(depth);
      input.idealForce *= i <= 40 ? 0.2 : 1.0; // upright on the way out
      input.cappedForce = input.idealForce;
      given += lastForce * (last - depth);
      damping += 0.5 * settings.maximumStiffness * (last - depth) * (last - depth);
      last = depth;
      lastForce = wall.Chain.apply(input).force.z();
      ASSERT_LE(given, damping + PassivityControl::Slack + 1e-12) << loop << ' ' << i;
    }
  }
}

TEST(SafetyTorque, StiffnessCapOfATorque)
{
  Contact contact;
  contact.torque = Vector3d(0.0, -3.0, 4.0); // N mm
  contact.tilt = 0.25;                       // 20 N mm/rad
  EXPECT_EQ(cappedTorqueShare(contact, Infinity), 1.0);
  EXPECT_EQ(cappedTorqueShare(contact, 20.0), 1.0);
  EXPECT_EQ(cappedTorqueShare(contact, 5.0), 0.25); // 1.25 N mm: a spring of 5 N mm/rad
  contact.tilt = 0.0;
  EXPECT_EQ(cappedTorqueShare(contact, Infinity), 1.0);
  EXPECT_EQ(cappedTorqueShare(contact, 5.0), 0.0);
  EXPECT_EQ(cappedTorqueShare(Contact(), 5.0), 1.0);
  // 1 N m/rad at the device. Distances in the body are twice as long, so M_body = 2000 M_device.
  SafetySettings settings = turning();
  settings.forceFactor = 0.5;
  EXPECT_EQ(SafetyChain(settings).bodyTorsionalLimit(2.0), 4000.0);
  settings.capStiffness = false;
  EXPECT_EQ(SafetyChain(settings).bodyTorsionalLimit(2.0), Infinity);
}

TEST(SafetyTorque, SettingsOutOfRangeAreNamed)
{
  const auto named = [](auto change)
  {
    SafetySettings settings = turning();
    change(settings);
    const SettingFault fault = faultOf(settings);
    return fault ? std::string(fault.name) + " " + fault.remark : std::string();
  };
  EXPECT_EQ(named([](SafetySettings&) {}), "");
  EXPECT_EQ(named([](SafetySettings& s) { s.maximumTorque = -0.5; }),
    "MaximumTorque must not be negative (N m), but is -0.5");
  EXPECT_EQ(named([](SafetySettings& s) { s.maximumTorsionalStiffness = 0.0; }),
    "MaximumTorsionalStiffness must be positive (N m/rad), but is 0");
  EXPECT_EQ(named([](SafetySettings& s) { s.maximumTorqueRate = NotANumber; }),
    "MaximumTorqueRate must be positive (N m/s), but is nan");
  DeviceSpecification none;
  none.maximumTorque = 3.0; // the device outputs no torque
  EXPECT_EQ(SafetySettings::of(none).maximumTorque, 0.0);
  EXPECT_EQ(SafetySettings::magnitudeOnly(5.0).maximumTorque, 0.0);
}
} // namespace safety_torque
