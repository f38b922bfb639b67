// SPDX-License-Identifier: BSD-3-Clause
// Each fault has its effect at its time and for its duration. Random faults occur at the given
// rate.
#include "FaultyDevice.h"
#include "Haptics/Simulation/SimulatedDevice.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace faulty_device
{
using Eigen::Vector3d;
using palpate::DeviceFault;
using palpate::DeviceFaults;
using palpate::DeviceSample;
using palpate::FaultyDevice;
using palpate::HandModel;
using palpate::NotANumber;
using palpate::SimulatedDevice;
using palpate::SimulatedPlant;

namespace
{
/// Makes a device with x = t at time t.
std::unique_ptr<SimulatedDevice> moving()
{
  return std::make_unique<SimulatedDevice>(
    std::vector<SimulatedDevice::WayPoint>{ { 0.0, { 0, 0, 0 } }, { 1024.0, { 1024.0, 0, 0 } } });
}

/// Returns the samples at 0, 1, ..., one letter each: the time of the measurement; '-' if the
/// sample is not fresh, 'x' if it is invalid, 'n' if it is not a number.
std::string told(FaultyDevice& device, int ticks)
{
  std::string text;
  for (int tick = 0; tick < ticks; ++tick)
  {
    const DeviceSample sample = device.read(tick);
    text += !sample.valid ? 'x'
      : !sample.fresh     ? '-'
      : !std::isfinite(sample.position.x())
      ? 'n'
      : static_cast<char>('0' + std::lround(sample.position.x()));
  }
  return text;
}

std::string told(const DeviceFaults& faults, int ticks = 10)
{
  FaultyDevice device(moving(), faults);
  return told(device, ticks);
}

DeviceFaults once(DeviceFault fault, double start, double duration = 0.0)
{
  DeviceFaults faults;
  faults.schedule.push_back({ fault, start, duration });
  return faults;
}
} // namespace

TEST(FaultyDevice, EachFaultOnSchedule)
{
  EXPECT_EQ(told(DeviceFaults()), "0123456789");
  EXPECT_EQ(told(once(DeviceFault::Dropped, 3.0)), "012-456789");
  // Samples 3 and 4 are dropped.
  EXPECT_EQ(told(once(DeviceFault::Dropped, 2.5, 2.0)), "012--56789");
  EXPECT_EQ(told(once(DeviceFault::Repeated, 3.0)), "0122456789");
  EXPECT_EQ(told(once(DeviceFault::Repeated, 3.0, 2.0)), "0122256789");
  EXPECT_EQ(told(once(DeviceFault::Late, 3.0, 2.0)), "012--36789"); // the sample of 3 arrives at 5
  EXPECT_EQ(told(once(DeviceFault::Late, 3.0)), "012-356789");
  EXPECT_EQ(told(once(DeviceFault::NotANumber, 3.0, 2.0)), "012nn56789");
  EXPECT_EQ(told(once(DeviceFault::Stall, 3.0, 4.0)), "012----789");
  EXPECT_EQ(told(once(DeviceFault::Disconnect, 3.0, 4.0)), "012xxxx789");
  EXPECT_EQ(told(once(DeviceFault::Disconnect, 3.0, 1e300)), "012xxxxxxx");
  EXPECT_EQ(told(once(DeviceFault::Dropped, 3.3, 0.2)), "0123-56789"); // affects the next reading
}

TEST(FaultyDevice, TheGravestHappens)
{
  DeviceFaults faults;
  faults.schedule = { { DeviceFault::Dropped, 1.0, 8.0 }, { DeviceFault::NotANumber, 0.0, 3.0 },
    { DeviceFault::Disconnect, 4.0, 2.0 }, { DeviceFault::Stall, 3.0, 5.0 } };
  FaultyDevice device(moving(), faults);
  EXPECT_EQ(told(device, 10),
    "n--"
    "-" // stalled
    "xx"
    "xx" // still stalled, without a last sample
    "x"  // dropped, without a last sample
    "9");
  EXPECT_EQ(device.errors().lost, 3U); // samples 1, 2 and 8
  EXPECT_EQ(device.errors().disconnections, 1U);
}

TEST(FaultyDevice, ForcesWhileStalledAndGone)
{
  DeviceFaults faults;
  faults.schedule = { { DeviceFault::Stall, 2.0, 2.0 }, { DeviceFault::Disconnect, 6.0, 2.0 } };
  auto inner = moving();
  SimulatedDevice& felt = *inner;
  FaultyDevice device(std::move(inner), faults);
  std::vector<double> forces;
  std::string taken;
  for (int tick = 0; tick < 10; ++tick)
  {
    device.read(tick);
    if (tick == 6)
    {
      EXPECT_EQ(felt.lastForce(), Vector3d::Zero()); // zero in the same tick
      EXPECT_EQ(device.status(), "disconnected, by a fault that was asked for");
    }
    taken += device.write({ 1.0 + tick, 0.0, 0.0 }) ? 'y' : 'n';
    forces.push_back(felt.lastForce().x());
  }
  EXPECT_EQ(taken, "yyyyyynnyy");
  EXPECT_EQ(forces, (std::vector<double>{ 1, 2, 2, 2, 5, 6, 0, 0, 9, 10 }));
  EXPECT_EQ(device.errors().unsent, 2U);
  EXPECT_EQ(device.errors().disconnections, 1U);
  EXPECT_EQ(device.status(), "connected");
}

TEST(FaultyDevice, APlantMovesOnMeanwhile)
{
  SimulatedPlant plant;
  plant.mass = 0.5;
  plant.damping = 0.0;
  FaultyDevice device(
    std::make_unique<SimulatedDevice>(plant, HandModel{ 0.0, 0.0 }, Vector3d(0, 0, 0)),
    once(DeviceFault::Disconnect, 1.0, 1.0));
  device.read(0.0);
  device.write({ 1.0, 0.0, 0.0 });
  EXPECT_FALSE(device.read(1.0).valid);          // 1 N on 0.5 kg for 1 s: 1 m, 2 m/s
  EXPECT_EQ(device.read(2.0).position.x(), 3.0); // 2 m/s without force for a second
}

TEST(FaultyDevice, RandomFaultsAreThoseOfTheirSeed)
{
  DeviceFaults faults;
  faults.rate(DeviceFault::Dropped) = { 0.1, 0.0 };
  faults.rate(DeviceFault::NotANumber) = { 0.05, 0.0 };
  faults.rate(DeviceFault::Stall) = { 0.01, 5.0 };
  faults.seed = 42;
  const std::string first = told(faults, 1000);
  EXPECT_EQ(told(faults, 1000), first);
  faults.seed = 43;
  EXPECT_NE(told(faults, 1000), first);
  // The first number of splitmix64 with seed 0 has been published: 0xE220A8397B1DCDAF, which is
  // 0.8833 of 2^64. The first number is used for NotANumber.
  for (const double probability : { 0.8832, 0.8834 })
  {
    DeviceFaults sure;
    sure.seed = 0;
    sure.rate(DeviceFault::NotANumber) = { probability, 0.0 };
    EXPECT_EQ(told(sure, 1), probability < 0.8833 ? "0" : "n");
  }
}

TEST(FaultyDevice, RandomFaultsComeAsOftenAsAskedFor)
{
  constexpr int Ticks = 100000;
  for (const auto kind : { DeviceFault::NotANumber, DeviceFault::Repeated, DeviceFault::Dropped,
         DeviceFault::Late, DeviceFault::Stall, DeviceFault::Disconnect })
  {
    DeviceFaults faults;
    faults.rate(kind) = { 0.02, 0.0 };
    FaultyDevice device(moving(), faults);
    int struck = 0;
    for (int tick = 0; tick < Ticks; ++tick)
    {
      const double time = tick / 128.0;
      const DeviceSample sample = device.read(time);
      struck += !sample.valid || !sample.fresh || sample.position.x() != time;
    }
    // A late sample affects its own reading and the next. The expectation of the binomial
    // distribution is 2000; the tolerance is 5 standard deviations of 44. Up to 1 of 50 late
    // samples overlap.
    const int expected = kind == DeviceFault::Late ? 4000 : 2000;
    EXPECT_NEAR(struck, expected, 5 * 45 + (kind == DeviceFault::Late ? 200 : 0))
      << static_cast<int>(kind);
  }
}

TEST(FaultyDevice, TheRateOfOneDoesNotMoveTheOthers)
{
  DeviceFaults few;
  few.rate(DeviceFault::Disconnect) = { 0.02, 0.0 };
  DeviceFaults many = few;
  many.rate(DeviceFault::Dropped) = { 0.5, 0.0 };
  const std::string a = told(few, 2000);
  const std::string b = told(many, 2000);
  int gone = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    gone += a[i] == 'x';
    EXPECT_TRUE(a[i] != 'x' || b[i] == 'x') << i;
  }
  EXPECT_GT(gone, 20);
}

TEST(FaultyDevice, WrongSettingsAreNamed)
{
  const auto status = [](const DeviceFaults& faults)
  {
    FaultyDevice device(moving(), faults);
    EXPECT_FALSE(device.read(0.0).valid);
    EXPECT_FALSE(device.write(Vector3d::Zero()));
    return device.status();
  };
  EXPECT_EQ(status(once(DeviceFault::Late, NotANumber)),
    "not connected: scheduled fault 0 has a start that is not finite");
  EXPECT_EQ(status(once(DeviceFault::Late, 0.0, -1.0)),
    "not connected: scheduled fault 0 has a duration that is negative or not a number");
  EXPECT_EQ(status(once(static_cast<DeviceFault>(9), 0.0)),
    "not connected: scheduled fault 0 is of no known kind");
  DeviceFaults faults;
  faults.rate(DeviceFault::Stall).probability = 1.5;
  EXPECT_EQ(status(faults), "not connected: the probability of Stall must be from 0 to 1");
  faults = {};
  faults.rate(DeviceFault::Dropped).duration = NotANumber;
  EXPECT_EQ(status(faults), "not connected: the duration of Dropped must not be negative");
}
} // namespace faulty_device
