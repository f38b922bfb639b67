// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/ServoLoop.h"

#include "Contact/LargePages.h"
#include "Haptics/Safety/ForceRelease.h"

#include <algorithm>
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

double secondsSince(std::int64_t begin, std::int64_t time) noexcept
{
  return static_cast<double>(time - begin) / NanosecondsPerSecond;
}

void sleepUntil(std::int64_t deadline) noexcept
{
  const timespec time{ deadline / NanosecondsPerSecond, deadline % NanosecondsPerSecond };
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) != 0)
  {
    // a signal has interrupted the sleep, which is repeated until the deadline
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
  if (!(this->rehearsal >= 0.0 && this->rehearsal <= 0.5 / this->rate))
  {
    return rangeFault("a rehearsal", this->rehearsal, " s", 0.0, 0.5 / this->rate);
  }
  if (this->realTime.priority < 0 || this->realTime.priority > 99)
  {
    return rangeFault("a real-time priority", this->realTime.priority, "", 0.0, 99.0);
  }
  return {};
}

ServoLoop::ServoLoop(HapticDevice& device, ServoStep step, const ServoLoopSettings& settings)
  : ServoLoop(std::vector<HapticDevice*>{ &device }, std::move(step), settings)
{
}

ServoLoop::ServoLoop(HapticDevice& device, ServoStep step, double rate)
  : ServoLoop(device, std::move(step), settingsOf(rate))
{
}

ServoLoop::ServoLoop(
  std::vector<HapticDevice*> devices, ServoStep step, const ServoLoopSettings& settings)
  : Devices(std::move(devices))
  , Step(std::move(step))
  , Settings(settings)
{
  this->Devices.resize(std::min(this->Devices.size(), this->Step.count()));
  for (std::size_t i = 0; i < this->Devices.size(); ++i)
  {
    this->Channels.push_back(std::make_unique<Channel>(recordedTicks(settings)));
  }
  this->resetStatistics();
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
  statistics.overruns = this->overruns() - this->OverrunsBefore;
  const DeviceErrors errors = this->errors();
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
  this->OverrunsBefore = this->overruns();
  this->ErrorsBefore = this->errors();
}

std::uint64_t ServoLoop::overruns() const noexcept
{
  std::uint64_t sum = 0;
  for (const std::unique_ptr<Channel>& channel : this->Channels)
  {
    sum += channel->recording.overruns();
  }
  return sum;
}

DeviceErrors ServoLoop::errors() const
{
  DeviceErrors sum;
  for (const HapticDevice* device : this->Devices)
  {
    const DeviceErrors errors = device->errors();
    sum.malformed += errors.malformed;
    sum.stale += errors.stale;
    sum.lost += errors.lost;
    sum.unsent += errors.unsent;
    sum.disconnections += errors.disconnections;
  }
  return sum;
}

bool ServoLoop::goesOn() const noexcept
{
  return !this->Stopping.load(std::memory_order_relaxed) && !ForceHold::mustRelease();
}

[[gnu::hot]] void ServoLoop::run(std::promise<RealTimeGrant>& granted) noexcept
{
  granted.set_value(requestRealTime(this->Settings.realTime));
  std::array<std::optional<ForceHold>, ServoStep::Most> holds;
  for (std::size_t i = 0; i < this->Devices.size(); ++i)
  {
    holds[i].emplace(*this->Devices[i]);
  }
  const auto period =
    static_cast<std::int64_t>(std::llround(NanosecondsPerSecond / this->Settings.rate));
  this->Newest.fill({});
  this->Samples.fill({});
  const std::int64_t begin = now();
  std::int64_t deadline = begin;
  std::int64_t before = begin; // start time of the last tick
  std::int64_t skipped = 0;    // number of skipped deadlines since the last tick
  const auto skip = [&](std::int64_t periods)
  {
    deadline += periods * period;
    skipped += periods;
  };
  while (this->goesOn())
  {
    const std::int64_t woken = now();
    const std::int64_t late = woken - deadline;
    const bool isFirst = deadline == begin;
    skip(late / period);
    this->takeScene();
    this->tick(secondsSince(begin, deadline));
    const std::int64_t done = now();
    // The statistics are updated after the force is sent, so that they do not delay the force.
    this->Meter.wakeUp.add(late);
    if (!isFirst)
    {
      this->Meter.period.add(woken - before);
    }
    before = woken;
    this->Meter.missed.add(static_cast<std::uint64_t>(skipped));
    skipped = 0;
    this->Meter.tick.add(done - woken);
    this->Meter.ticks.add();
    deadline += period;
    if (done >= deadline)
    {
      skip((done - deadline) / period + 1);
    }
    this->Step.foresee();
    this->wait(deadline, secondsSince(begin, deadline));
  }
  this->finish();
}

[[gnu::hot]] void ServoLoop::tick(double time) noexcept
{
  for (std::size_t i = 0; i < this->Devices.size(); ++i)
  {
    const Eigen::Vector3d before = this->Samples[i].position;
    this->Samples[i] = this->Devices[i]->read(time);
    this->Likely[i] = this->Samples[i];
    this->Likely[i].position += this->Samples[i].position - before;
  }
  this->Step.step(this->Samples.data(), time, this->Newest.data());
  for (std::size_t i = 0; i < this->Devices.size(); ++i)
  {
    this->write(i, this->Samples[i], this->Newest[i]);
  }
}

[[gnu::hot]] void ServoLoop::write(
  std::size_t device, const DeviceSample& sample, const Tick& tick) noexcept
{
  this->Devices[device]->holdFor(tick.holdTime);
  const bool taken = this->Devices[device]->writeWrench(tick.wrench());
  this->Channels[device]->latest.write(tick);
  this->Channels[device]->recording.push(tick);
  this->Meter.invalidSamples.add(sample.valid ? 0 : 1);
  this->Meter.repeatedSamples.add(sample.valid && !sample.fresh ? 1 : 0);
  this->Meter.refusedForces.add(taken ? 0 : 1);
}

void ServoLoop::wait(std::int64_t deadline, double time) noexcept
{
  if (this->Settings.rehearsal == 0.0)
  {
    sleepUntil(deadline);
    return;
  }
  sleepUntil(deadline -
    static_cast<std::int64_t>(std::llround(this->Settings.rehearsal * NanosecondsPerSecond)));
  this->rehearse(time);
  while (now() < deadline && this->goesOn())
  {
    // a sleep that is so short would end too late
  }
}

void ServoLoop::rehearse(double time) noexcept
{
  this->Step.rehearse(this->Likely.data(), time, this->Rehearsed.data());
  for (std::size_t i = 0; i < this->Devices.size(); ++i)
  {
    this->Channels[i]->latest.prepare(this->Rehearsed[i]);
    this->Channels[i]->recording.prepare(this->Rehearsed[i]);
  }
  prefetchLine(&this->Scenes);
  prefetchLine(&this->Meter.invalidSamples);
  prefetchLine(&this->Meter.refusedForces);
}

[[gnu::hot]] void ServoLoop::takeScene() noexcept
{
  if (std::unique_ptr<ServoScene> scene = this->Scenes.take())
  {
    this->Step.change(std::move(scene));
    this->Meter.sceneChanges.add();
  }
  this->Scenes.giveBack(this->Step.takeRetired());
}

void ServoLoop::finish() noexcept
{
  // A device may still be busy with the last force, and a disconnected device accepts no force.
  // Therefore the write is repeated.
  constexpr int Attempts = 10;
  constexpr std::int64_t Pause = NanosecondsPerSecond / 1000;
  std::array<bool, ServoStep::Most> isDone{};
  bool areAll = false;
  for (int i = 0; i < Attempts && !areAll; ++i)
  {
    if (i > 0)
    {
      sleepUntil(now() + Pause);
    }
    areAll = true;
    for (std::size_t d = 0; d < this->Devices.size(); ++d)
    {
      isDone[d] = isDone[d] || this->Devices[d]->writeWrench({});
      areAll = areAll && isDone[d];
    }
  }
  this->Step.reset();
  this->Scenes.giveBack(this->Step.takeRetired());
  for (std::size_t d = 0; d < this->Devices.size(); ++d)
  {
    const Tick& newest = this->Newest[d];
    Tick last;
    last.time = newest.time;
    last.tip = newest.tip;
    last.scene = newest.scene;
    last.acted = static_cast<std::uint16_t>(SafetyLink::Stopped);
    this->Channels[d]->latest.write(last);
  }
}
} // namespace palpate
