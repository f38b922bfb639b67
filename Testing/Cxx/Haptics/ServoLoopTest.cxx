// SPDX-License-Identifier: BSD-3-Clause
// The servo thread ticks, publishes its ticks, and leaves zero force at the end. No times are
// checked.
#include "Haptics/Servo/ServoLoop.h"

#include "SampleResponses.h"
#include "StandingDevice.h"
#include "Haptics/Simulation/SimulatedDevice.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

namespace servo_loop
{
using Eigen::Vector3d;
using namespace palpate;
using palpate::NotANumber;
using namespace palpate::testing;

namespace
{
/// F = 10 δ^1.5 under a tip half a millimetre deep in a ball of 20 mm.
const Vector3d Inside(0.0, 0.0, 0.0195); // m

// The force of one step outside of any loop. `step` is a copy, so the loop's own step is not
// changed.
Vector3d forceAt(const Vector3d& position, ServoStep step)
{
  DeviceSample sample;
  sample.position = position;
  sample.valid = true;
  return step.step(sample, 0.0).contact.force;
}
} // namespace

TEST(ServoLoop, TicksPublishesAndStopsWithZeroForce)
{
  const auto body = uniformBody(icosphere(20.0, 3));
  StandingDevice device(Inside);
  const ServoStep step(*body, WorkspaceMapping(), 10.0);
  ServoLoop loop(device, step, 1000.0);
  EXPECT_FALSE(loop.isRunning());
  EXPECT_EQ(loop.start(), "");
  EXPECT_TRUE(loop.isRunning());
  EXPECT_EQ(loop.grant().request.priority, 80);
  waitForTicks(loop, 50);
  EXPECT_EQ(loop.newest().contact.force, forceAt(device.Position, step));
  loop.stop();
  EXPECT_FALSE(loop.isRunning());
  EXPECT_TRUE(device.Increasing);
  EXPECT_GT(device.Strongest, 0.1);
  EXPECT_EQ(device.Last, Vector3d::Zero());
  const Tick& last = loop.newest();
  EXPECT_EQ(last.contact.force, Vector3d::Zero()) << "no stale force after stop";
  EXPECT_EQ(last.appliedForce, Vector3d::Zero());
  EXPECT_EQ(last.deviceForce, Vector3d::Zero());
  EXPECT_EQ(last.acted, static_cast<std::uint16_t>(SafetyLink::Stopped));
  EXPECT_FALSE(last.valid);
}

// Compares the loop with a loop that sleeps until the tick, for the same reading.
TEST(ServoLoop, ARehearsalChangesNoForce)
{
  const auto body = uniformBody(icosphere(20.0, 3));
  StandingDevice device(Inside);
  ServoLoopSettings settings;
  settings.rehearsal = 2e-4;
  settings.realTime.priority = 0; // otherwise it may take a processor from other threads
  const ServoStep step(*body, WorkspaceMapping(), 10.0);
  ServoLoop loop(device, step, settings);
  ASSERT_EQ(loop.start(), "");
  waitForTicks(loop, 50);
  EXPECT_EQ(loop.newest().contact.force, forceAt(device.Position, step));
  loop.stop();
  EXPECT_TRUE(device.Increasing);
  EXPECT_EQ(device.Last, Vector3d::Zero());
}

// A rehearsed step gives the same bits in every tick of a path with stick, slide, exit and
// re-entry.
TEST(ServoStep, ARehearsalIsForgotten)
{
  const std::shared_ptr<const ContactBody> body = uniformBody(icosphere(20.0, 3));
  ContactSettings contact;
  contact.friction.coefficient = 0.4;
  const SafetySettings safety = SafetySettings::of({});
  ServoStep rehearsed(std::make_unique<ServoScene>(body, contact), WorkspaceMapping(), safety);
  ServoStep plain(std::make_unique<ServoScene>(body, contact), WorkspaceMapping(), safety);
  int pressed = 0;
  Tick likely;
  for (int tick = 0; tick < 3000; ++tick)
  {
    const double t = 1e-3 * tick;
    DeviceSample sample;
    sample.valid = tick % 701 != 0;
    sample.position = (0.0196 + 0.0006 * std::sin(9.0 * t)) *
      Vector3d(std::sin(t) * std::cos(3.0 * t), std::sin(t) * std::sin(3.0 * t), std::cos(t));
    if (tick % 3 > 0)
    {
      likely = rehearsed.rehearse(sample, t); // rehearses the sample that step() gets
    }
    DeviceSample another = sample;
    another.position *= 0.999;
    another.valid = tick % 17 != 0;
    rehearsed.rehearse(another, t);
    const Tick one = rehearsed.step(sample, t);
    const Tick other = plain.step(sample, t);
    if (tick % 3 > 0)
    {
      ASSERT_EQ(likely.contact.force, other.contact.force) << tick;
      ASSERT_EQ(likely.deviceForce, other.deviceForce) << tick;
      ASSERT_EQ(likely.acted, other.acted) << tick;
    }
    ASSERT_EQ(one.contact.force, other.contact.force) << tick;
    ASSERT_EQ(one.deviceForce, other.deviceForce) << tick;
    pressed += one.contact.normalForce > 0.0;
  }
  EXPECT_GT(pressed, 1000);
}

TEST(ServoLoop, StartsAgainAndMayBeDestroyedWhileRunning)
{
  const auto body = uniformBody(icosphere(20.0, 3));
  StandingDevice device(Inside);
  {
    ServoLoop loop(device, ServoStep(*body, WorkspaceMapping(), 10.0), 4000.0);
    loop.start();
    waitForTicks(loop, 5);
    loop.stop();
    loop.stop();
    const std::uint64_t before = loop.ticks();
    device.Time = -1.0;
    loop.start();
    waitForTicks(loop, before + 5);
  }
  EXPECT_EQ(device.Last, Vector3d::Zero());
}

TEST(ServoLoop, AnExceptionOfTheOwnerLeavesZeroForce)
{
  const auto body = uniformBody(icosphere(20.0, 3));
  StandingDevice device(Inside);
  const auto fail = [&]
  {
    ServoLoop loop(device, ServoStep(*body, WorkspaceMapping(), 10.0), 1000.0);
    loop.start();
    waitForTicks(loop, 5);
    throw std::runtime_error("the owner's");
  };
  EXPECT_THROW(fail(), std::runtime_error);
  EXPECT_GT(device.Strongest, 0.1);
  EXPECT_EQ(device.Last, Vector3d::Zero());
}

namespace
{
/// Accepts zero force only at the fourth request. At the first three requests the device is busy.
class BusyDevice final : public StandingDevice
{
public:
  using StandingDevice::StandingDevice;
  bool write(const Vector3d& force) noexcept override
  {
    return (!force.isZero() || ++this->Zeros > 3) && StandingDevice::write(force);
  }
  int Zeros = 0;
};

/// Refuses all forces, like an unplugged device.
class GoneDevice final : public StandingDevice
{
public:
  using StandingDevice::StandingDevice;
  bool write(const Vector3d&) noexcept override { return false; }
};
} // namespace

TEST(ServoLoop, ZeroForceIsOfferedAgainToABusyDeviceButNotForEverToOneThatIsGone)
{
  const auto body = uniformBody(icosphere(20.0, 3));
  BusyDevice busy(Inside);
  ServoLoop first(busy, ServoStep(*body, WorkspaceMapping(), 10.0), 1000.0);
  first.start();
  waitForTicks(first, 5);
  first.stop();
  EXPECT_GT(busy.Strongest, 0.1);
  EXPECT_EQ(busy.Last, Vector3d::Zero());

  GoneDevice gone(Inside);
  ServoLoop second(gone, ServoStep(*body, WorkspaceMapping(), 10.0), 1000.0);
  second.start();
  waitForTicks(second, 5);
  second.stop();
  EXPECT_EQ(second.statistics().refusedForces, second.ticks());
}

TEST(ServoLoop, SettingsThatCannotBeAreNamed)
{
  const auto body = uniformBody(icosphere(20.0, 1));
  StandingDevice device(Inside);
  const auto faultOf = [&](double rate, double recorded, int priority, double rehearsal = 0.0)
  {
    ServoLoopSettings settings;
    settings.rate = rate;
    settings.recordedSeconds = recorded;
    settings.realTime.priority = priority;
    settings.rehearsal = rehearsal;
    ServoLoop loop(device, ServoStep(*body, WorkspaceMapping(), 10.0), settings);
    const std::string fault = loop.start();
    EXPECT_EQ(loop.isRunning(), fault.empty());
    return fault;
  };
  EXPECT_EQ(faultOf(0.5, 0.0, 0), "a rate of 0.5 ticks per second: it must be 1 to 100000");
  EXPECT_EQ(faultOf(NotANumber, 0.0, 0), "a rate of nan ticks per second: it must be 1 to 100000");
  EXPECT_EQ(faultOf(200e3, 0.0, 0), "a rate of 200000 ticks per second: it must be 1 to 100000");
  EXPECT_EQ(faultOf(1e3, -1.0, 0), "a recording of -1000 ticks: it must be 0 to 1e+07");
  EXPECT_EQ(faultOf(1e3, NotANumber, 0), "a recording of nan ticks: it must be 0 to 1e+07");
  EXPECT_EQ(faultOf(1e3, 1e5, 0), "a recording of 1e+08 ticks: it must be 0 to 1e+07");
  EXPECT_EQ(faultOf(1e3, 0.0, 100), "a real-time priority of 100: it must be 0 to 99");
  EXPECT_EQ(faultOf(1e3, 0.0, -1), "a real-time priority of -1: it must be 0 to 99");
  EXPECT_EQ(faultOf(1e3, 0.0, 0, -1e-4), "a rehearsal of -0.0001 s: it must be 0 to 0.0005");
  EXPECT_EQ(faultOf(1e3, 0.0, 0, 6e-4), "a rehearsal of 0.0006 s: it must be 0 to 0.0005");
  EXPECT_EQ(faultOf(1e3, 0.0, 0, NotANumber), "a rehearsal of nan s: it must be 0 to 0.0005");
  EXPECT_EQ(faultOf(1e3, 0.0, 0), "");
}

TEST(SteeredHand, ApproachesItsTargetExponentially)
{
  SimulatedDevice device(Vector3d::Zero());
  EXPECT_EQ(device.read(0.0).position, Vector3d::Zero());
  device.steerTo(Vector3d(0.01, 0.0, -0.02));
  // After one time constant the hand has moved 1 - 1/e of the distance, for any steps (rounding of
  // 30 products).
  for (int i = 1; i <= 30; ++i)
  {
    device.read(i * SteeredTarget::TimeConstant / 30.0);
  }
  const DeviceSample sample = device.read(SteeredTarget::TimeConstant);
  EXPECT_TRUE(sample.valid);
  EXPECT_NEAR(sample.position.x(), 0.01 * (1.0 - std::exp(-1.0)), 1e-15);
  EXPECT_NEAR(sample.position.z(), -0.02 * (1.0 - std::exp(-1.0)), 1e-15);
}

TEST(SteeredHand, ATargetThatIsNotFiniteGivesNoSample)
{
  SimulatedDevice device(Vector3d(0.0, 0.0, 0.01));
  device.read(0.0);
  device.steerTo(Vector3d(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0));
  EXPECT_FALSE(device.read(0.001).valid);
  device.steerTo(Vector3d(0.0, 0.0, 0.01));
  const DeviceSample sample = device.read(0.002);
  EXPECT_TRUE(sample.valid);
  EXPECT_EQ(sample.position, Vector3d(0.0, 0.0, 0.01));
}
} // namespace servo_loop
