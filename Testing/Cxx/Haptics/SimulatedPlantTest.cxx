// SPDX-License-Identifier: BSD-3-Clause
// The simulated device with a mass in a hand: timing of forces and readings, encoders, targets,
// determinism, wrong settings. Its mechanics are tested in PlantAxisTest and StabilityLimitTest.
#include "Haptics/Simulation/SimulatedDevice.h"

#include "Agreement.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace simulated_plant
{
using namespace palpate::testing;
using Eigen::Vector3d;
using palpate::DeviceSample;
using palpate::DeviceSpecification;
using palpate::HandModel;
using palpate::NotANumber;
using palpate::SimulatedDevice;
using palpate::SimulatedPlant;
using palpate::SteeredTarget;

namespace
{
const HandModel Nobody{ 0.0, 0.0 };
const Vector3d Origin = Vector3d::Zero();
constexpr double Period = 0.25; // s; exact in binary, like the delays

/// 0.5 kg without losses: a force of 1 N gives t² metres.
SimulatedPlant plainMass()
{
  SimulatedPlant plant;
  plant.mass = 0.5;
  plant.damping = 0.0;
  return plant;
}

bool sameBits(const Vector3d& a, const Vector3d& b)
{
  return std::memcmp(a.data(), b.data(), sizeof(double) * 3) == 0;
}
} // namespace

TEST(SimulatedPlant, HoldsAForceUntilTheNext)
{
  SimulatedDevice device(plainMass(), Nobody, Origin);
  EXPECT_EQ(device.read(10.0).position, Origin);
  EXPECT_TRUE(device.write({ 1.0, 0.0, -2.0 }));
  DeviceSample sample = device.read(10.5);
  EXPECT_EQ(sample.position, Vector3d(0.25, 0.0, -0.5));
  EXPECT_EQ(sample.velocity, Vector3d(1.0, 0.0, -2.0));
  EXPECT_TRUE(sample.valid && sample.fresh);
  sample = device.read(11.0); // without a new force, the last force is held
  EXPECT_EQ(sample.position, Vector3d(1.0, 0.0, -2.0));
  device.write(Origin);
  sample = device.read(12.0);
  EXPECT_EQ(sample.position, Vector3d(3.0, 0.0, -6.0));
  EXPECT_EQ(device.lastForce(), Origin);
}

TEST(SimulatedPlant, TheLastOfTwoForcesInOneTickCounts)
{
  SimulatedDevice device(plainMass(), Nobody, Origin);
  device.read(0.0);
  device.write({ 100.0, 0.0, 0.0 });
  device.write({ 1.0, 0.0, 0.0 });
  EXPECT_EQ(device.read(1.0).position.x(), 1.0);
}

TEST(SimulatedPlant, DelaysOfTheForce)
{
  for (const double ticks : { 0.25, 1.0, 2.5 })
  {
    SimulatedPlant plant = plainMass();
    plant.forceDelay = ticks * Period;
    DeviceSpecification specification;
    specification.rate = 1.0 / Period;
    SimulatedDevice device(plant, Nobody, Origin, specification);
    for (int tick = 0; tick < 12; ++tick)
    {
      const Vector3d x = device.read(tick * Period).position;
      const double acting = Period * std::max(0.0, tick - ticks);
      EXPECT_DOUBLE_EQ(x.x(), acting * acting) << ticks;
      EXPECT_DOUBLE_EQ(device.trueVelocity().x(), 2.0 * acting) << ticks;
      device.write({ 1.0, 0.0, 0.0 });
    }
  }
}

TEST(SimulatedPlant, DelaysOfTheSample)
{
  for (const double ticks : { 0.25, 1.0, 2.5 })
  {
    SimulatedPlant plant = plainMass();
    plant.sampleDelay = ticks * Period;
    // A stiff hand on a path: the reading is a past position.
    SimulatedDevice device(
      plant, { 1e9, 1e6 }, { { 0.0, { 0, 0, 0 } }, { 100.0, { 100.0, 0, 0 } } });
    for (int tick = 0; tick < 12; ++tick)
    {
      EXPECT_NEAR(
        device.read(tick * Period).position.x(), Period * std::max(0.0, tick - ticks), 1e-6)
        << ticks;
    }
  }
}

TEST(SimulatedPlant, ForcesFasterThanTheirDelay)
{
  // A force that arrives more than four times faster than specified replaces the previous force.
  SimulatedPlant plant = plainMass();
  plant.forceDelay = 0.5;
  DeviceSpecification specification;
  specification.rate = 10.0;
  SimulatedDevice device(plant, Nobody, Origin, specification);
  for (int tick = 0; tick <= 10000; ++tick)
  {
    device.read(1e-3 * tick);
    device.write({ 1.0, 0.0, 0.0 });
  }
  // 9.5 s with 1 N, without loss.
  EXPECT_TRUE(agrees(device.read(10.0 + 1e-9).position.x(), 9.5 * 9.5, 1e-6));
}

TEST(SimulatedPlant, EncodersRound)
{
  SimulatedPlant plant = plainMass();
  plant.encoderStep = 0.125;
  SimulatedDevice device(plant, Nobody, Origin);
  device.read(0.0);
  EXPECT_EQ(device.read(0.0).velocity, Origin);
  device.write({ 1.0, -1.0, 0.0 });
  DeviceSample sample = device.read(0.25); // at 0.0625, half a step: rounded away from zero
  EXPECT_EQ(sample.position, Vector3d(0.125, -0.125, 0.0));
  sample = device.read(0.5); // the true position is 0.25
  EXPECT_EQ(sample.position, Vector3d(0.25, -0.25, 0.0));
  EXPECT_EQ(sample.velocity, Vector3d(0.5, -0.5, 0.0)); // computed from the readings
  EXPECT_EQ(device.truePosition(), Vector3d(0.25, -0.25, 0.0));
  EXPECT_EQ(device.trueVelocity(), Vector3d(1.0, -1.0, 0.0));
  sample = device.read(0.55); // the true position is 0.3025
  EXPECT_EQ(sample.position, Vector3d(0.25, -0.25, 0.0));
  EXPECT_TRUE(agrees(device.truePosition().x(), 0.3025, 1e-15));
}

TEST(SimulatedPlant, FollowsAPathWithinTheTick)
{
  SimulatedPlant plant;
  const HandModel hand{ 500.0, 8.0 };
  const std::vector<SimulatedDevice::WayPoint> path = { { 0.0, { 0, 0, 0 } },
    { 0.0104, { 0.001, 0, 0 } }, { 0.0104, { 0.003, 0, 0.002 } }, { 0.0213, { 0, 0, 0 } } };
  SimulatedDevice often(plant, hand, path);
  SimulatedDevice seldom(plant, hand, path);
  EXPECT_EQ(often.duration(), 0.0213);
  for (int i = 0; i <= 400; ++i)
  {
    often.read(1e-4 * i);
  }
  seldom.read(0.0);
  seldom.read(0.04);
  // Corners and jumps of the path are located exactly, so only rounding errors differ.
  EXPECT_NEAR((often.truePosition() - seldom.truePosition()).norm(), 0.0, 1e-15);
  EXPECT_GT(seldom.truePosition().norm(), 1e-6);
}

TEST(SimulatedPlant, ASteeredHand)
{
  const HandModel stiff{ 1e8, 14e3 }; // its time constant is 0.07 ms
  SimulatedDevice device(plainMass(), stiff, Vector3d(0.01, 0.0, 0.0));
  EXPECT_EQ(device.read(0.0).position, Vector3d(0.01, 0.0, 0.0));
  device.steerTo({ 0.0, 0.02, 0.0 });
  for (int tick = 1; tick <= 100; ++tick)
  {
    const Vector3d x = device.read(1e-3 * tick).position;
    const double share = std::exp(-1e-3 * tick / SteeredTarget::TimeConstant);
    // The speed of the target, at most 0.7 m/s, changes from tick to tick. The hand has settled
    // before the end of each tick.
    EXPECT_NEAR(x.x(), 0.01 * share, 1e-8);
    EXPECT_NEAR(x.y(), 0.02 * (1.0 - share), 1e-8);
  }
  device.steerTo({ NotANumber, 0.0, 0.0 }); // ignored
  const Vector3d before = device.read(0.101).position;
  EXPECT_TRUE(device.read(0.102).valid);
  EXPECT_NEAR((device.read(0.2).position - before).norm(), 0.0, 1e-3);
}

TEST(SimulatedPlant, SteeredFromAnotherThread)
{
  SimulatedDevice device(SimulatedPlant(), { 1e4, 60.0 }, Origin);
  std::thread mouse(
    [&]
    {
      for (int i = 1; i <= 1000; ++i)
      {
        device.steerTo(Vector3d::Constant(1e-5 * i));
      }
    });
  double time = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3d x = device.read(time += 1e-3).position;
    EXPECT_EQ(x.x(), x.y()); // a target is never read partly written
    EXPECT_EQ(x.x(), x.z());
  }
  mouse.join();
  for (int i = 0; i < 1000; ++i)
  {
    device.read(time += 1e-3);
  }
  EXPECT_NEAR(device.read(time + 1e-3).position.x(), 0.01, 1e-6);
}

TEST(SimulatedPlant, DeterministicToTheBit)
{
  SimulatedPlant plant;
  plant.friction = 0.1;
  plant.encoderStep = 2e-6;
  plant.forceDelay = 0.3e-3;
  plant.sampleDelay = 1.1e-3;
  HandModel hand;
  hand.maximumForce = 2.0;
  const std::vector<SimulatedDevice::WayPoint> path = { { 0.0, { 0, 0, 0.01 } },
    { 0.5, { 0.01, 0, -0.02 } }, { 1.0, { 0, 0.003, 0.01 } } };
  SimulatedDevice first(plant, hand, path);
  SimulatedDevice second(plant, hand, path);
  int pressing = 0;
  for (int tick = 0; tick < 1500; ++tick)
  {
    const double time = tick / 1000.0;
    const DeviceSample a = first.read(time);
    const DeviceSample b = second.read(time);
    ASSERT_TRUE(sameBits(a.position, b.position) && sameBits(a.velocity, b.velocity)) << tick;
    ASSERT_TRUE(sameBits(first.truePosition(), second.truePosition())) << tick;
    const Vector3d force(0.0, 0.0, a.position.z() < 0.0 ? -500.0 * a.position.z() : 0.0);
    pressing += force.z() > 0.0;
    first.write(force);
    second.write(force);
  }
  EXPECT_GT(pressing, 200);
}

TEST(SimulatedPlant, ATimeThatDoesNotIncrease)
{
  SimulatedDevice device(plainMass(), Nobody, Origin);
  device.read(0.0);
  device.write({ 1.0, 0.0, 0.0 });
  const DeviceSample at = device.read(1.0);
  for (const double time : { 1.0, 0.5, -3.0 })
  {
    const DeviceSample again = device.read(time);
    EXPECT_TRUE(again.valid);
    EXPECT_FALSE(again.fresh);
    EXPECT_EQ(again.position, at.position);
  }
  for (const double time : { NotANumber, std::numeric_limits<double>::infinity() })
  {
    EXPECT_FALSE(device.read(time).valid);
  }
  EXPECT_EQ(device.read(2.0).position.x(), 4.0); // the refused forces have not moved it
}

TEST(SimulatedPlant, RefusesAForceThatIsNotFinite)
{
  SimulatedDevice device(plainMass(), Nobody, Origin);
  device.read(0.0);
  device.write({ 1.0, 0.0, 0.0 });
  device.read(1.0);
  EXPECT_FALSE(device.write({ NotANumber, 0.0, 0.0 }));
  EXPECT_EQ(device.read(2.0).position.x(), 3.0); // the mass continues at 2 m/s
}

TEST(SimulatedPlant, WrongSettingsAreNamed)
{
  const auto status = [](const SimulatedPlant& plant, const HandModel& hand,
                        const std::vector<SimulatedDevice::WayPoint>& path, double rate)
  {
    DeviceSpecification specification;
    specification.rate = rate;
    SimulatedDevice device(plant, hand, path, specification);
    EXPECT_FALSE(device.read(0.0).valid);
    device.write({ 1.0, 0.0, 0.0 });
    EXPECT_FALSE(device.read(1.0).valid);
    return device.status();
  };
  const HandModel hand;
  SimulatedPlant plant;
  plant.mass = 0.0;
  EXPECT_EQ(
    status(plant, hand, {}, 1e3), "not simulated: mass must be from 1e-06 to 1e+09 kg, not 0");
  plant = {};
  plant.damping = -1.0;
  EXPECT_EQ(
    status(plant, hand, {}, 1e3), "not simulated: damping must be from 0 to 1e+09 N s/m, not -1");
  plant = {};
  plant.sampleDelay = 2.0;
  EXPECT_EQ(
    status(plant, hand, {}, 1e3), "not simulated: sample-delay must be from 0 to 1 s, not 2");
  plant = {};
  plant.encoderStep = NotANumber;
  EXPECT_EQ(
    status(plant, hand, {}, 1e3), "not simulated: encoder-step must be from 0 to 1e+09 m, not nan");
  EXPECT_EQ(status({}, { -5.0, 0.0 }, {}, 1e3),
    "not simulated: stiffness must be from 0 to 1e+09 N/m, not -5");
  EXPECT_EQ(status({}, hand, { { 0.0, { NotANumber, 0, 0 } } }, 1e3),
    "not simulated: way point 0 is not finite");
  EXPECT_EQ(status({}, hand, { { 1.0, { 0, 0, 0 } }, { 0.0, { 0, 0, 0 } } }, 1e3),
    "not simulated: way point 1 is earlier than the one before");
  EXPECT_EQ(status({}, hand, {}, 0.0), "not simulated: rate must be above 0, to 100000 Hz");
  SimulatedDevice fine({}, hand, std::vector<SimulatedDevice::WayPoint>{});
  EXPECT_EQ(fine.status(), "connected");
}

TEST(SimulatedPlant, IsReadFromText)
{
  palpate::HeldPlant held;
  ASSERT_EQ(palpate::readPlant("", held), "");
  EXPECT_EQ(held.plant.mass, 0.1);
  EXPECT_EQ(held.hand.stiffness, 300.0);
  ASSERT_EQ(palpate::readPlant("stiffness=1e3,mass=0.2,damping=3,friction=0.5,encoder-step=1e-5,"
                               "force-delay=0.001,sample-delay=0.002,hand-damping=0,hand-force=20,"
                               "inertia=2e-4,turn-damping=1e-3,turn-stiffness=0.3,"
                               "turn-hand-damping=2e-3",
              held),
    "");
  EXPECT_EQ(held.plant.mass, 0.2);
  EXPECT_EQ(held.plant.damping, 3.0);
  EXPECT_EQ(held.plant.friction, 0.5);
  EXPECT_EQ(held.plant.encoderStep, 1e-5);
  EXPECT_EQ(held.plant.forceDelay, 0.001);
  EXPECT_EQ(held.plant.sampleDelay, 0.002);
  EXPECT_EQ(held.hand.stiffness, 1000.0);
  EXPECT_EQ(held.hand.damping, 0.0);
  EXPECT_EQ(held.hand.maximumForce, 20.0);
  EXPECT_EQ(held.plant.inertia, 2e-4);
  EXPECT_EQ(held.plant.turnDamping, 1e-3);
  EXPECT_EQ(held.hand.turnStiffness, 0.3);
  EXPECT_EQ(held.hand.turnHandDamping, 2e-3);
  const std::string known =
    " is no setting of a plant; it has mass (kg), damping (N s/m), friction "
    "(N), encoder-step (m), force-delay (s), sample-delay (s), stiffness "
    "(N/m), hand-damping (N s/m), hand-force (N), inertia (kg m\u00b2), turn-damping (N m s/rad), "
    "turn-stiffness (N m/rad), turn-hand-damping (N m s/rad)";
  const std::pair<const char*, std::string> wrong[] = {
    { ",", "''" + known },
    { "mass=1,", "''" + known },
    { "Mass=1", "'Mass'" + known },
    { "mass=1,damping=1,mass=1", "mass is given twice" },
    { "mass", "mass: '' is not a finite number" },
    { "mass=", "mass: '' is not a finite number" },
    { "mass=1kg", "mass: '1kg' is not a finite number" },
    { "hand-force=inf", "hand-force: 'inf' is not a finite number" },
    { "mass=0", "mass must be from 1e-06 to 1e+09 kg, not 0" },
    { "damping=-1", "damping must be from 0 to 1e+09 N s/m, not -1" },
    { "force-delay=2", "force-delay must be from 0 to 1 s, not 2" },
    { "hand-force=-1", "hand-force must be from 0 to inf N, not -1" },
    { "inertia=-1", "inertia must be from 0 to 1e+09 kg m\u00b2, not -1" },
  };
  for (const auto& [text, error] : wrong)
  {
    EXPECT_EQ(palpate::readPlant(text, held), error) << text;
    EXPECT_EQ(held.plant.mass, 0.2); // `held` is unchanged
  }
}

TEST(SimulatedPlant, StatesWhatASampledLoopMayRender)
{
  // b > KT/2 (Colgate and Schenkel 1997). StabilityLimitTest has the exact limits of such loops:
  // 2003.339 N/m, and 668.513 N/m with a delay of one tick. Loops with half of these stiffnesses
  // come to rest.
  EXPECT_EQ(palpate::specificationOf(SimulatedPlant(), 1000.0).maximumStiffness, 1000.0);
  SimulatedPlant late;
  late.forceDelay = 0.0005;
  late.sampleDelay = 0.0005;
  const DeviceSpecification device = palpate::specificationOf(late, 1000.0);
  EXPECT_NEAR(device.maximumStiffness, 1000.0 / 3.0, 1e-9);
  EXPECT_EQ(device.delay, 0.001);
  EXPECT_EQ(device.maximumDamping, 1.0);
  EXPECT_EQ(device.rate, 1000.0);
}
} // namespace simulated_plant
