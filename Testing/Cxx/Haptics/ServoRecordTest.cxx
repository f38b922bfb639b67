// SPDX-License-Identifier: BSD-3-Clause
// The results of a servo loop: every tick, and statistics that account for every period. The only
// time that is checked is a delay that the test device causes.
#include "SampleResponses.h"
#include "Haptics/Servo/ServoLoop.h"
#include "StandingDevice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <thread>
#include <vector>

using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
ServoLoopSettings recording(double rate, double seconds)
{
  ServoLoopSettings settings;
  settings.rate = rate;
  settings.recordedSeconds = seconds;
  return settings;
}

/// Reports the number of the tick, 0, 1, …, in its buttons.
class NumberingDevice final : public StandingDevice
{
public:
  using StandingDevice::StandingDevice;

protected:
  void onRead(DeviceSample& sample, std::uint64_t number) override
  {
    sample.buttons = static_cast<std::uint32_t>(number);
  }
};

/// Fails in known ticks: every third sample is invalid, every fifth sample is a repetition, every
/// seventh force is refused.
class FailingDevice final : public StandingDevice
{
public:
  using StandingDevice::StandingDevice;
  bool write(const Vector3d&) noexcept override { return ++this->Writes % 7 != 0; }
  DeviceErrors errors() const noexcept override { return this->Errors; }

  DeviceErrors Errors;
  std::uint64_t Writes = 0;

protected:
  void onRead(DeviceSample& sample, std::uint64_t number) override
  {
    sample.valid = (number + 1) % 3 != 0;
    sample.fresh = (number + 1) % 5 != 0;
  }
};

/// Delays its tenth reading by the given time.
class StallingDevice final : public StandingDevice
{
public:
  StallingDevice(const Vector3d& where, std::chrono::microseconds stall)
    : StandingDevice(where)
    , Stall(stall)
  {
  }

protected:
  void onRead(DeviceSample&, std::uint64_t number) override
  {
    if (number == 9)
    {
      std::this_thread::sleep_for(this->Stall);
    }
  }

private:
  std::chrono::microseconds Stall;
};
} // namespace

TEST(ServoRecord, HoldsEveryTick)
{
  constexpr double Rate = 4000.0;
  const auto body = uniformBody(icosphere(20.0, 3));
  NumberingDevice device(Vector3d(0.0, 0.0, 0.0195));
  ServoLoop loop(device, ServoStep(*body, WorkspaceMapping(), 10.0), recording(Rate, 30.0));
  ASSERT_EQ(loop.start(), "");
  std::uint32_t next = 0;
  double lastTime = -1.0;
  const auto check = [&](const Tick& tick)
  {
    EXPECT_EQ(tick.buttons, next++);
    EXPECT_GT(tick.time, lastTime);
    // Times are multiples of the period: seconds from whole nanoseconds.
    EXPECT_NEAR(tick.time * Rate, std::round(tick.time * Rate), 1e-9);
    EXPECT_GT(tick.deviceForce.norm(), 0.1);
    lastTime = tick.time;
  };
  while (next < 1000)
  {
    loop.drain(check);
  }
  loop.stop();
  loop.drain(check);
  EXPECT_EQ(next, loop.ticks());
  EXPECT_EQ(loop.statistics().overruns, 0u);
  EXPECT_EQ(loop.drain(check), 0u);
}

TEST(ServoRecord, WhatHadNoRoomIsCounted)
{
  const auto body = uniformBody(icosphere(20.0, 3));
  NumberingDevice device(Vector3d(0.0, 0.0, 0.0195));
  ServoLoop loop(device, ServoStep(*body, WorkspaceMapping(), 10.0), recording(2000.0, 0.01));
  ASSERT_EQ(loop.start(), "");
  waitForTicks(loop, 60);
  loop.stop();
  std::vector<std::uint32_t> kept;
  loop.drain([&](const Tick& tick) { kept.push_back(tick.buttons); });
  ASSERT_EQ(kept.size(), 20u);
  EXPECT_EQ(kept.back(), 19u) << "the oldest are kept";
  EXPECT_EQ(loop.statistics().overruns, loop.ticks() - 20);
  loop.resetStatistics();
  EXPECT_EQ(loop.statistics().overruns, 0u);
}

TEST(ServoRecord, StatisticsCountWhatWentWrong)
{
  const auto body = uniformBody(icosphere(20.0, 3));
  FailingDevice device(Vector3d(0.0, 0.0, 0.0195));
  device.Errors = { 1, 2, 3, 4, 5 };
  ServoLoop loop(device, ServoStep(*body, WorkspaceMapping(), 10.0), 4000.0);
  device.Errors = { 11, 22, 33, 44, 55 };
  ASSERT_EQ(loop.start(), "");
  waitForTicks(loop, 200);
  loop.stop();
  const ServoStatistics all = loop.statistics();
  EXPECT_EQ(all.rate, 4000.0);
  EXPECT_EQ(all.grant.describe(), loop.grant().describe());
  EXPECT_EQ(all.ticks, loop.ticks());
  EXPECT_EQ(all.missed, loop.missed());
  EXPECT_EQ(all.invalidSamples, all.ticks / 3);
  EXPECT_EQ(all.repeatedSamples, all.ticks / 5 - all.ticks / 15)
    << "an invalid one is no repetition";
  EXPECT_EQ(all.refusedForces, all.ticks / 7);
  EXPECT_EQ(all.overruns, 0u) << "nothing is recorded, so nothing is lost";
  EXPECT_EQ(all.device.malformed, 10u);
  EXPECT_EQ(all.device.stale, 20u);
  EXPECT_EQ(all.device.lost, 30u);
  EXPECT_EQ(all.device.unsent, 40u);
  EXPECT_EQ(all.device.disconnections, 50u);
  EXPECT_EQ(all.wakeUp.total(), all.ticks);
  EXPECT_EQ(all.tick.total(), all.ticks);
  EXPECT_EQ(all.period.total(), all.ticks - 1);
  const std::string text = all.describe();
  EXPECT_NE(text.find("4000 per second; SCHED_FIFO 80 "), std::string::npos) << text;
  EXPECT_NE(text.find("\n" + std::to_string(all.ticks) + " ticks, "), std::string::npos) << text;
  EXPECT_NE(text.find("50 disconnections\nperiod "), std::string::npos) << text;

  loop.resetStatistics();
  const ServoStatistics none = loop.statistics();
  EXPECT_EQ(none.ticks + none.missed + none.invalidSamples + none.repeatedSamples +
      none.refusedForces + none.device.malformed + none.device.disconnections,
    0u);
  EXPECT_EQ(none.wakeUp.total() + none.period.total() + none.tick.total(), 0u);
  EXPECT_EQ(loop.ticks(), all.ticks) << "these are since the loop was made";
}

TEST(ServoRecord, PeriodsThatPassInATickAreMissedAndTheGridStays)
{
  constexpr double Rate = 1000.0;
  const auto body = uniformBody(icosphere(20.0, 3));
  StallingDevice device(Vector3d(0.0, 0.0, 0.0195), std::chrono::microseconds(7500));
  ServoLoop loop(device, ServoStep(*body, WorkspaceMapping(), 10.0), recording(Rate, 10.0));
  ASSERT_EQ(loop.start(), "");
  waitForTicks(loop, 30);
  loop.stop();
  std::vector<double> times;
  loop.drain([&](const Tick& tick) { times.push_back(tick.time); });
  // The missed ticks are those that were due during the tenth tick, which took 7.5 periods or more.
  // The tenth tick may have begun late, and other ticks may have been missed.
  EXPECT_GE(loop.missed(), 7u);
  EXPECT_GE(times[10] - times[9], 7.999e-3);
  EXPECT_NEAR(times.back() * Rate, static_cast<double>(loop.ticks() + loop.missed() - 1), 1e-9);
  const ServoStatistics statistics = loop.statistics();
  EXPECT_GE(statistics.tick.worst(), 7500000);
  EXPECT_GE(statistics.period.worst(), 7500000);
  EXPECT_LT(statistics.tick.quantile(0.5), 7500000);
}

TEST(ServoRecord, AReadingHoldsTheOneBefore)
{
  const auto body = uniformBody(icosphere(20.0, 3));
  StandingDevice device(Vector3d(0.0, 0.0, 0.0195));
  ServoLoop loop(device, ServoStep(*body, WorkspaceMapping(), 10.0), 8000.0);
  ASSERT_EQ(loop.start(), "");
  ServoStatistics before;
  while (before.ticks < 1000)
  {
    const ServoStatistics now = loop.statistics();
    ASSERT_GE(now.ticks, before.ticks);
    ASSERT_GE(now.missed, before.missed);
    ASSERT_GE(now.tick.total(), before.tick.total());
    ASSERT_GE(now.tick.worst(), before.tick.worst());
    ASSERT_GE(now.period.total(), before.period.total());
    ASSERT_GE(now.wakeUp.total(), now.tick.total() > 0 ? now.ticks : 0);
    before = now;
  }
}
