// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/ServoLoop.h"

#include "Haptics/Safety/ForceRelease.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <system_error>
#include <utility>

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

ServoLoopSettings settingsOf(double rate)
{
  ServoLoopSettings settings;
  settings.rate = rate;
  return settings;
}

std::size_t recordedTicks(const ServoLoopSettings& settings)
{
  return settings.fault().empty()
    ? static_cast<std::size_t>(std::ceil(settings.recordedSeconds * settings.rate))
    : 0;
}

std::string rangeFault(const char* what, double value, const char* unit, double least, double most)
{
  std::array<char, 128> text{};
  std::snprintf(
    text.data(), text.size(), "%s of %g%s: it must be %g to %g", what, value, unit, least, most);
  return text.data();
}
} // namespace

std::string ServoLoopSettings::fault() const
{
  if (!(this->rate >= 1.0 && this->rate <= MaximumRate))
  {
    return rangeFault("a rate", this->rate, " ticks per second", 1.0, MaximumRate);
  }
  const double recorded = this->recordedSeconds * this->rate;
  if (!(recorded >= 0.0 && recorded <= MaximumRecordedTicks))
  {
    return rangeFault("a recording", recorded, " ticks", 0.0, MaximumRecordedTicks);
  }
  if (this->realTime.priority < 0 || this->realTime.priority > 99)
  {
    return rangeFault("a real-time priority", this->realTime.priority, "", 0.0, 99.0);
  }
  return {};
}

ServoLoop::ServoLoop(HapticDevice& device, ServoStep step, const ServoLoopSettings& settings)
  : Device(device)
  , Step(std::move(step))
  , Settings(settings)
  , Recording(recordedTicks(settings))
{
  this->resetStatistics();
}

ServoLoop::ServoLoop(HapticDevice& device, ServoStep step, double rate)
  : ServoLoop(device, std::move(step), settingsOf(rate))
{
}

ServoLoop::~ServoLoop()
{
  this->stop();
}

std::string ServoLoop::start()
{
  std::string fault = this->Settings.fault();
  if (!fault.empty() || this->isRunning())
  {
    return fault;
  }
  this->Stopping.store(false);
  try
  {
    std::promise<RealTimeGrant> granted;
    std::future<RealTimeGrant> grant = granted.get_future();
    this->Thread =
      std::thread([this, settled = std::move(granted)]() mutable { this->run(settled); });
    this->Grant = grant.get();
  }
  catch (const std::system_error& error)
  {
    return std::string("no servo thread: ") + error.what();
  }
  return {};
}

void ServoLoop::stop()
{
  if (this->isRunning())
  {
    this->Stopping.store(true);
    this->Thread.join();
    this->Scenes.collect();
  }
}

void ServoLoop::changeScene(std::unique_ptr<ServoScene> scene)
{
  this->Scenes.offer(std::move(scene));
  this->Scenes.collect();
}

ServoStatistics ServoLoop::statistics() const
{
  ServoStatistics statistics;
  this->Meter.read(statistics);
  statistics.rate = this->Settings.rate;
  statistics.grant = this->Grant;
  statistics.overruns = this->Recording.overruns() - this->OverrunsBefore;
  const DeviceErrors errors = this->Device.errors();
  statistics.device.malformed = errors.malformed - this->ErrorsBefore.malformed;
  statistics.device.stale = errors.stale - this->ErrorsBefore.stale;
  statistics.device.lost = errors.lost - this->ErrorsBefore.lost;
  statistics.device.unsent = errors.unsent - this->ErrorsBefore.unsent;
  statistics.device.disconnections = errors.disconnections - this->ErrorsBefore.disconnections;
  return statistics;
}

void ServoLoop::resetStatistics()
{
  this->Meter.reset();
  this->OverrunsBefore = this->Recording.overruns();
  this->ErrorsBefore = this->Device.errors();
}

bool ServoLoop::goesOn() const noexcept
{
  return !this->Stopping.load(std::memory_order_relaxed) && !ForceHold::mustRelease();
}

void ServoLoop::run(std::promise<RealTimeGrant>& granted) noexcept
{
  granted.set_value(requestRealTime(this->Settings.realTime));
  const ForceHold hold(this->Device);
  const auto period =
    static_cast<std::int64_t>(std::llround(NanosecondsPerSecond / this->Settings.rate));
  const std::int64_t begin = now();
  std::int64_t deadline = begin;
  std::int64_t before = begin; // when the last tick began
  std::int64_t skipped = 0;    // deadlines since then
  const auto skip = [&](std::int64_t periods)
  {
    deadline += periods * period;
    skipped += periods;
  };
  Tick newest;
  while (this->goesOn())
  {
    const std::int64_t woken = now();
    this->Meter.wakeUp.add(woken - deadline);
    if (deadline > begin)
    {
      this->Meter.period.add(woken - before);
    }
    before = woken;
    skip((woken - deadline) / period);
    this->Meter.missed.add(static_cast<std::uint64_t>(skipped));
    skipped = 0;
    this->takeScene();
    newest = this->tick(static_cast<double>(deadline - begin) / NanosecondsPerSecond);
    const std::int64_t done = now();
    this->Meter.tick.add(done - woken);
    this->Meter.ticks.add();
    deadline += period;
    if (done >= deadline)
    {
      skip((done - deadline) / period + 1);
    }
    this->Step.foresee();
    sleepUntil(deadline);
  }
  this->finish(newest);
}

Tick ServoLoop::tick(double time) noexcept
{
  const DeviceSample sample = this->Device.read(time);
  Tick tick = this->Step.step(sample, time);
  this->Device.holdFor(tick.holdTime);
  const bool taken = this->Device.writeWrench(tick.wrench());
  this->Latest.write(tick);
  this->Recording.push(tick);
  this->Meter.invalidSamples.add(sample.valid ? 0 : 1);
  this->Meter.repeatedSamples.add(sample.valid && !sample.fresh ? 1 : 0);
  this->Meter.refusedForces.add(taken ? 0 : 1);
  return tick;
}

void ServoLoop::takeScene() noexcept
{
  if (std::unique_ptr<ServoScene> scene = this->Scenes.take())
  {
    this->Step.change(std::move(scene));
    this->Meter.sceneChanges.add();
  }
  this->Scenes.giveBack(this->Step.takeRetired());
}

void ServoLoop::finish(const Tick& newest) noexcept
{
  // A device may be at work on the force before; one that is gone takes none.
  constexpr int Attempts = 10;
  constexpr std::int64_t Pause = NanosecondsPerSecond / 1000;
  for (int i = 1; !this->Device.writeWrench({}) && i < Attempts; ++i)
  {
    sleepUntil(now() + Pause);
  }
  this->Step.reset();
  this->Scenes.giveBack(this->Step.takeRetired());
  Tick last;
  last.time = newest.time;
  last.tip = newest.tip;
  last.scene = newest.scene;
  last.acted = static_cast<std::uint16_t>(SafetyLink::Stopped);
  this->Latest.write(last);
}
} // namespace palpate
