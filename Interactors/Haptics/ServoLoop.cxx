// SPDX-License-Identifier: BSD-3-Clause
#include "ServoLoop.h"

#include <cmath>
#include <cstdint>

#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <ctime>

namespace palpate
{
namespace
{
constexpr std::int64_t NanosecondsPerSecond = 1000000000;

std::int64_t now() noexcept
{
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * NanosecondsPerSecond + time.tv_nsec;
}

void sleepUntil(std::int64_t deadline) noexcept
{
  const timespec time{ deadline / NanosecondsPerSecond, deadline % NanosecondsPerSecond };
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) != 0)
  {
    // woken by a signal: the deadline still stands
  }
}
} // namespace

ServoLoop::ServoLoop(HapticDevice& device, const ServoStep& step, double rate)
  : Device(device)
  , Step(step)
  , Period(1.0 / rate)
{
}

ServoLoop::~ServoLoop()
{
  this->stop();
}

void ServoLoop::start()
{
  if (!this->isRunning())
  {
    this->Stopping = false;
    this->Thread = std::thread([this] { this->run(); });
  }
}

void ServoLoop::stop()
{
  if (this->isRunning())
  {
    this->Stopping = true;
    this->Thread.join();
  }
}

void ServoLoop::run() noexcept
{
#ifdef __linux__
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL); // ns; the default of 50 µs delays each tick
#endif
  const auto period = static_cast<std::int64_t>(std::llround(this->Period * NanosecondsPerSecond));
  const std::int64_t begin = now();
  std::int64_t deadline = begin;
  while (!this->Stopping.load(std::memory_order_relaxed))
  {
    const double time = static_cast<double>(deadline - begin) / NanosecondsPerSecond;
    const ServoTick tick = this->Step.step(this->Device.read(time), time);
    this->Device.write(tick.deviceForce);
    this->Latest.write(tick);
    this->Ticks.fetch_add(1, std::memory_order_relaxed);
    deadline += period;
    const std::int64_t late = now() - deadline;
    if (late > period)
    {
      const std::int64_t skipped = late / period;
      deadline += skipped * period;
      this->Missed.fetch_add(static_cast<std::uint64_t>(skipped), std::memory_order_relaxed);
    }
    sleepUntil(deadline);
  }
  this->Step.reset();
  this->Device.write(Eigen::Vector3d::Zero());
  this->Latest.write(ServoTick());
}
} // namespace palpate
