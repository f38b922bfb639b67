// SPDX-License-Identifier: BSD-3-Clause
// The ticks of the servo thread do not use the heap: with a recording that is drained, with a
// recording that overruns, with changes of scene, late ticks, and a device that fails.
#include "AllocationCount.h"
#include "SampleResponses.h"
#include "Haptics/Servo/ServoLoop.h"
#include "StandingDevice.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
/// Records the allocation count of the servo thread at its second reading and at the newest
/// reading. All allocations between these readings belong to ticks. The hand moves in and out.
class CountingDevice final : public StandingDevice
{
public:
  CountingDevice()
    : StandingDevice(Vector3d(0.0, 0.0, 0.0195))
  {
  }
  bool write(const Vector3d& force) noexcept override
  {
    StandingDevice::write(force);
    return this->Reads % 11 != 0;
  }
  long First = 0; ///< may be read after the loop has ended
  std::atomic<long> Newest{ 0 };
  bool Allocates = false;

protected:
  void onRead(DeviceSample& sample, std::uint64_t number) override
  {
    sample.position.z() += number % 20 < 10 ? 0.0 : 0.002;
    sample.valid = number % 13 != 0;
    if (number % 97 == 0)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1)); // the next ticks are missed
    }
    if (number == 1)
    {
      this->First = allocationCount();
    }
    if (this->Allocates && number == 5)
    {
      delete new volatile int(1);
    }
    this->Newest = allocationCount();
  }
};

long allocationsOfTicks(CountingDevice& device, double recordedSeconds, bool drains)
{
  const std::shared_ptr<const ContactBody> body = uniformBody(icosphere(20.0, 3));
  ServoLoopSettings settings;
  settings.rate = 4000.0;
  settings.recordedSeconds = recordedSeconds;
  settings.rehearsal = drains ? 1e-4 : 0.0;
  ServoLoop loop(device,
    ServoStep(std::make_unique<ServoScene>(body), WorkspaceMapping(),
      SafetySettings::of(device.specification())),
    settings);
  EXPECT_EQ(loop.start(), "");
  while (loop.ticks() < 2000)
  {
    loop.changeScene(std::make_unique<ServoScene>(body));
    if (drains)
    {
      loop.drain([](const Tick&) {});
    }
    waitForTicks(loop, loop.ticks() + 10);
  }
  loop.stop();
  const ServoStatistics statistics = loop.statistics();
  EXPECT_GT(statistics.missed, 10u); // late ticks and scene changes have occurred
  EXPECT_GT(statistics.sceneChanges, 10u);
  EXPECT_GT(statistics.refusedForces, 10u);
  EXPECT_GT(statistics.invalidSamples, 10u);
  EXPECT_EQ(statistics.overruns > 0, !drains && recordedSeconds > 0.0);
  EXPECT_GT(device.Strongest, 0.1);
  return device.Newest - device.First;
}
} // namespace

TEST(ServoAllocation, TicksTouchNoHeap)
{
  CountingDevice drained;
  EXPECT_EQ(allocationsOfTicks(drained, 10.0, true), 0);
  CountingDevice overrun;
  EXPECT_EQ(allocationsOfTicks(overrun, 0.1, false), 0);
  CountingDevice unrecorded;
  EXPECT_EQ(allocationsOfTicks(unrecorded, 0.0, false), 0);
}

TEST(ServoAllocation, OneInATickWouldBeSeen)
{
  CountingDevice device;
  device.Allocates = true;
  EXPECT_EQ(allocationsOfTicks(device, 0.0, false), countsMalloc() ? 3 : 2);
}
