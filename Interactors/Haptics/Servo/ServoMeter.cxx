// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/ServoMeter.h"

#include <array>
#include <cstdio>

namespace palpate
{
namespace
{
std::string timesLine(const char* name, const LatencyCounts& times)
{
  const auto microseconds = [&](double share)
  { return 1e-3 * static_cast<double>(times.quantile(share)); };
  std::array<char, 160> line{};
  std::snprintf(line.data(), line.size(),
    "%-8s median %.1f µs, 99 %% %.1f, 99.9 %% %.1f, worst %.1f\n", name, microseconds(0.5),
    microseconds(0.99), microseconds(0.999), 1e-3 * static_cast<double>(times.worst()));
  return line.data();
}

void addCount(std::string& text, std::uint64_t count, const char* what)
{
  text += ", " + std::to_string(count) + " " + what;
}
} // namespace

std::string ServoStatistics::describe() const
{
  std::array<char, 64> asked{};
  std::snprintf(asked.data(), asked.size(), "%g per second; ", this->rate);
  std::string text = asked.data() + this->grant.describe() + "\n";
  text += std::to_string(this->ticks) + " ticks";
  addCount(text, this->missed, "missed");
  addCount(text, this->overruns, "not recorded");
  addCount(text, this->sceneChanges, "changes of scene");
  text += "\ndevice: " + std::to_string(this->invalidSamples) + " ticks without a valid sample";
  addCount(text, this->repeatedSamples, "without a new one");
  addCount(text, this->refusedForces, "forces refused");
  addCount(text, this->device.malformed, "reports malformed");
  addCount(text, this->device.stale, "stale");
  addCount(text, this->device.lost, "lost");
  addCount(text, this->device.unsent, "forces unsent");
  addCount(text, this->device.disconnections, "disconnections");
  text += "\n" + timesLine("period", this->period);
  text += timesLine("wake-up", this->wakeUp);
  text += timesLine("tick", this->tick);
  return text;
}

void ServoMeter::read(ServoStatistics& statistics) const noexcept
{
  statistics.ticks = this->ticks.read();
  statistics.missed = this->missed.read();
  statistics.invalidSamples = this->invalidSamples.read();
  statistics.repeatedSamples = this->repeatedSamples.read();
  statistics.refusedForces = this->refusedForces.read();
  statistics.sceneChanges = this->sceneChanges.read();
  statistics.period = this->period.read();
  statistics.wakeUp = this->wakeUp.read();
  statistics.tick = this->tick.read();
}

void ServoMeter::reset() noexcept
{
  for (EventCount* const count : { &this->ticks, &this->missed, &this->invalidSamples,
         &this->repeatedSamples, &this->refusedForces, &this->sceneChanges })
  {
    count->reset();
  }
  for (LatencyHistogram* const times : { &this->period, &this->wakeUp, &this->tick })
  {
    times->reset();
  }
}
} // namespace palpate
