// SPDX-License-Identifier: BSD-3-Clause
// Reading and writing the simulated, faulty, recording and replaying devices does not use the heap.
#include "AllocationCount.h"
#include "FaultyDevice.h"
#include "RecordingDevice.h"
#include "SampleResponses.h"
#include "Contact/ContactBody.h"
#include "Haptics/Devices/ReplayDevice.h"
#include "Haptics/Simulation/SimulatedDevice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

using Eigen::Vector3d;
using namespace palpate::testing;
using palpate::DeviceFault;
using palpate::DeviceSample;
using palpate::HapticDevice;
using palpate::SimulatedDevice;

namespace
{
constexpr int Ticks = 5000;

struct Met
{
  int valid = 0;
  int invalid = 0;
  int stale = 0;
  int pressing = 0;
};

/// Presses a virtual wall below 0. Some times are NaN, or repeat or jump.
Met expectNoAllocation(HapticDevice& device)
{
  Met met;
  double time = 0.0;
  const long before = allocationCount();
  for (int tick = 0; tick < Ticks; ++tick)
  {
    time += tick % 311 == 0 ? 0.0 : tick % 501 == 0 ? 0.05 : 1e-3;
    const DeviceSample sample =
      device.read(tick % 997 == 0 ? std::numeric_limits<double>::quiet_NaN() : time);
    met.valid += sample.valid;
    met.invalid += !sample.valid;
    met.stale += !sample.fresh;
    const double depth = -sample.position.z();
    const double force = sample.valid && depth > 0.0 ? 800.0 * depth : 0.0;
    met.pressing += force > 0.0;
    device.writeWrench({ { 0.0, 0.0, force }, { 0.01, 0.0, -0.02 } });
    static_cast<void>(device.errors());
  }
  EXPECT_EQ(allocationCount(), before);
  EXPECT_GT(met.valid, Ticks / 2);
  EXPECT_GT(met.invalid, 3);
  EXPECT_GT(met.pressing, Ticks / 10);
  return met;
}

std::vector<SimulatedDevice::WayPoint> toAndFro()
{
  std::vector<SimulatedDevice::WayPoint> path;
  for (int i = 0; i < 60; ++i)
  {
    path.push_back({ 0.1 * i, { 1e-3 * (i % 3), 0.0, i % 2 == 0 ? 0.004 : -0.008 },
      { 0.0, 0.2 * (i % 4), 1.0 } });
  }
  return path;
}

/// Makes a device with friction, limits, encoders and delays, so that all events of the plant
/// occur.
std::unique_ptr<SimulatedDevice> everything(bool isSteered = false)
{
  palpate::SimulatedPlant plant;
  plant.friction = 0.2;
  plant.encoderStep = 1e-6;
  plant.forceDelay = 2.3e-3;
  plant.sampleDelay = 0.7e-3;
  plant.inertia = 1e-4;
  palpate::HandModel hand;
  hand.maximumForce = 1.5;
  return isSteered ? std::make_unique<SimulatedDevice>(plant, hand, Vector3d(0.0, 0.0, 0.004))
                   : std::make_unique<SimulatedDevice>(plant, hand, toAndFro());
}
} // namespace

TEST(DeviceAllocation, SimulatedPlant)
{
  EXPECT_GT(expectNoAllocation(*everything()).stale, 10);
}

TEST(DeviceAllocation, SteeredPlant)
{
  const auto device = everything(true);
  const long before = allocationCount();
  device->steerTo({ 0.0, 0.0, -0.008 });
  device->turnTo({ 0.3, 0.0, -1.0 });
  EXPECT_EQ(allocationCount(), before);
  expectNoAllocation(*device);
}

/// A hand that moves around a body, with searches, paths, slides and contacts.
TEST(DeviceAllocation, GuidedHand)
{
  const std::shared_ptr<const palpate::ContactBody> body = uniformBody(icosphere(20.0, 2));
  SimulatedDevice device(Vector3d(0.0, 0.0, 0.1));
  device.setBody(body, palpate::WorkspaceMapping());
  double time = 0.0;
  Vector3d last = Vector3d::Zero();
  double way = 0.0;
  for (int goal = 0; goal < 40; ++goal)
  {
    const Vector3d normal =
      Vector3d(std::cos(goal), std::sin(goal), std::cos(0.7 * goal)).normalized();
    device.touch(20.0 * normal, normal, goal % 3 == 0 ? 3.0 : -1.0);
    if (goal % 5 == 0)
    {
      device.steerTo(0.001 * goal * normal);
    }
    const long before = allocationCount();
    for (int tick = 0; tick < 150; ++tick)
    {
      const DeviceSample sample = device.read(time += 1e-3);
      way += (sample.position - last).norm();
      last = sample.position;
    }
    EXPECT_EQ(allocationCount(), before);
  }
  EXPECT_GT(way, 1.0); // m; a dozen times halfway around the body
}

TEST(DeviceAllocation, Faulty)
{
  palpate::DeviceFaults faults;
  for (std::size_t i = 0; i < palpate::DeviceFaultCount; ++i)
  {
    faults.rates[i] = { 0.01, 3e-3 };
    faults.schedule.push_back({ static_cast<DeviceFault>(i), 0.3 * static_cast<double>(i), 0.01 });
  }
  palpate::FaultyDevice device(everything(), faults);
  EXPECT_GT(expectNoAllocation(device).stale, 100);
  EXPECT_GT(device.errors().disconnections, 10U);
}

TEST(DeviceAllocation, RecordingAndReplay)
{
  palpate::RecordingDevice recorder(everything(), Ticks / 2); // some readings do not fit
  expectNoAllocation(recorder);
  EXPECT_GT(recorder.overruns(), 1000U);
  std::vector<palpate::RecordedSample> samples;
  recorder.drain(samples);
  // Samples whose time is NaN are not written to a file.
  std::vector<palpate::RecordedSample> timed;
  for (const palpate::RecordedSample& sample : samples)
  {
    if (std::isfinite(sample.time))
    {
      timed.push_back(sample);
    }
  }
  palpate::ReplayDevice replay(
    palpate::trajectoryOf(timed, palpate::WorkspaceMapping()), palpate::WorkspaceMapping());
  expectNoAllocation(replay);
}
