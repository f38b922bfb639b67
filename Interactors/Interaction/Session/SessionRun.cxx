// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Session/SessionRun.h"

#include <chrono>
#include <utility>

namespace palpate
{
VirtualRun::VirtualRun(
  std::shared_ptr<HapticDevice> hand, ServoStep servo, double rate, const TicksKept& kept)
  : SessionRun(std::move(hand), rate, kept)
  , Step(std::move(servo))
  , Period(1.0 / rate)
{
}

void VirtualRun::stop()
{
  if (this->Running)
  {
    this->Running = false;
    this->Device->writeWrench({});
  }
}

void VirtualRun::change(std::unique_ptr<ServoScene> scene)
{
  this->Step.change(std::move(scene));
}

double VirtualRun::time() const
{
  return static_cast<double>(this->Summary.ticks) * this->Period;
}

void VirtualRun::step(double seconds)
{
  // Half a tick of slack, so that steps which add up to a whole number of ticks run that many.
  this->Reached += seconds;
  const double end = this->Reached - 0.5 * this->Period;
  while (this->time() < end)
  {
    this->tick();
  }
}

void VirtualRun::tick()
{
  const double time = this->time();
  const auto begin = std::chrono::steady_clock::now();
  this->Newest = this->Step.step(this->Device->read(time), time);
  this->Device->writeWrench(this->Newest.wrench());
  const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - begin;
  this->Step.takeRetired(); // and freed here: the tick is over
  this->keep(this->Newest);
  if (this->KeepsAll)
  {
    this->Nanoseconds.push_back(spent.count());
  }
}

RealTimeRun::RealTimeRun(std::shared_ptr<HapticDevice> hand, ServoStep servo,
  const ServoLoopSettings& settings, const TicksKept& kept)
  : SessionRun(std::move(hand), settings.rate, kept)
  , Loop(*this->Device, std::move(servo), settings)
{
}

void RealTimeRun::change(std::unique_ptr<ServoScene> scene)
{
  this->Loop.changeScene(std::move(scene));
}

const Tick& RealTimeRun::newest()
{
  this->collect(); // whoever looks at the newest tick at display rate keeps the ring from filling
  return this->Loop.newest();
}

void RealTimeRun::collect()
{
  this->Loop.freeScenes();
  this->Loop.drain([this](const Tick& tick) { this->keep(tick); });
}
} // namespace palpate
