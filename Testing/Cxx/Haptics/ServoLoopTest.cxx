// SPDX-License-Identifier: BSD-3-Clause
// The servo thread: it ticks, publishes, and leaves zero force. No time is asserted.
#include "ServoLoop.h"

#include "SampleResponses.h"
#include "SteeredDevice.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
/// A device that stands still, counts and remembers; read by the test after the loop has stopped.
class StandingDevice final : public HapticDevice
{
public:
  explicit StandingDevice(const Vector3d& where)
    : Position(where)
  {
  }
  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  DeviceSample read(double time) noexcept override
  {
    this->Increasing = this->Increasing && time > this->Time;
    this->Time = time;
    DeviceSample sample;
    sample.position = this->Position;
    sample.valid = true;
    return sample;
  }
  bool write(const Vector3d& force) noexcept override
  {
    this->Strongest = std::max(this->Strongest, force.norm());
    this->Last = force;
    return true;
  }

  DeviceSpecification Limits;
  Vector3d Position;
  Vector3d Last = Vector3d::Zero();
  double Strongest = 0.0;
  double Time = -1.0;
  bool Increasing = true;
};

/// Waits for the loop to have made `count` ticks; bounded by the test's own time limit.
void waitForTicks(const ServoLoop& loop, std::uint64_t count)
{
  while (loop.ticks() < count)
  {
    std::this_thread::yield();
  }
}
} // namespace

TEST(ServoLoop, TicksPublishesAndStopsWithZeroForce)
{
  const auto body = uniformBody(icosphere(20.0, 3));
  StandingDevice device(Vector3d(0.0, 0.0, 0.0195)); // m: half a millimetre deep
  const ServoStep step(*body, WorkspaceMapping(), 10.0);
  ServoLoop loop(device, step, 1000.0);
  EXPECT_FALSE(loop.isRunning());
  loop.start();
  EXPECT_TRUE(loop.isRunning());
  waitForTicks(loop, 50);
  ServoStep same = step;
  DeviceSample sample;
  sample.position = device.Position;
  sample.valid = true;
  EXPECT_EQ(loop.newest().contact.force, same.step(sample, 0.0).contact.force);
  loop.stop();
  EXPECT_FALSE(loop.isRunning());
  EXPECT_TRUE(device.Increasing);
  EXPECT_GT(device.Strongest, 0.1);
  EXPECT_EQ(device.Last, Vector3d::Zero());
  EXPECT_EQ(loop.newest().contact.force, Vector3d::Zero()) << "no stale force after stop";
}

TEST(ServoLoop, StartsAgainAndMayBeDestroyedWhileRunning)
{
  const auto body = uniformBody(icosphere(20.0, 3));
  StandingDevice device(Vector3d(0.0, 0.0, 0.0195));
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

TEST(SteeredDevice, ApproachesItsTargetExponentially)
{
  SteeredDevice device(Vector3d::Zero());
  EXPECT_EQ(device.read(0.0).position, Vector3d::Zero());
  device.steerTo(Vector3d(0.01, 0.0, -0.02));
  // After one time constant 1 - 1/e of the way, whatever the steps (rounding of 30 products).
  for (int i = 1; i <= 30; ++i)
  {
    device.read(i * SteeredDevice::TimeConstant / 30.0);
  }
  const DeviceSample sample = device.read(SteeredDevice::TimeConstant);
  EXPECT_TRUE(sample.valid);
  EXPECT_NEAR(sample.position.x(), 0.01 * (1.0 - std::exp(-1.0)), 1e-15);
  EXPECT_NEAR(sample.position.z(), -0.02 * (1.0 - std::exp(-1.0)), 1e-15);
}

TEST(SteeredDevice, ATargetThatIsNotFiniteGivesNoSample)
{
  SteeredDevice device(Vector3d(0.0, 0.0, 0.01));
  device.read(0.0);
  device.steerTo(Vector3d(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0));
  EXPECT_FALSE(device.read(0.001).valid);
  device.steerTo(Vector3d(0.0, 0.0, 0.01));
  const DeviceSample sample = device.read(0.002);
  EXPECT_TRUE(sample.valid);
  EXPECT_EQ(sample.position, Vector3d(0.0, 0.0, 0.01));
}
