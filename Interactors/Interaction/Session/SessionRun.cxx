// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Session/SessionRun.h"

#include <chrono>
#include <utility>

namespace palpate
{
namespace
{
std::vector<HapticDevice*> pointersTo(const SessionHands& hands)
{
  std::vector<HapticDevice*> devices;
  for (const auto& hand : hands)
  {
    devices.push_back(hand.get());
  }
  return devices;
}
} // namespace

VirtualRun::VirtualRun(SessionHands hands, ServoStep servo, double rate, const TicksKept& kept)
  : SessionRun(std::move(hands), rate, kept)
  , Step(std::move(servo))
  , Period(1.0 / rate)
  , Samples(this->hands())
  , Newest(this->hands())
{
}

void VirtualRun::stop()
{
  if (this->Running)
  {
    this->Running = false;
    for (const auto& hand : this->Hands)
    {
      hand->writeWrench({});
    }
  }
}

void VirtualRun::change(std::unique_ptr<ServoScene> scene)
{
  this->Step.change(std::move(scene));
}

double VirtualRun::time() const
{
  return static_cast<double>(this->ticksMade()) * this->Period;
}

void VirtualRun::step(double seconds)
{
  // The tolerance of half a tick ensures that exactly n ticks run if the steps add up to n ticks.
  this->ReachedTime += seconds;
  const double end = this->ReachedTime - 0.5 * this->Period;
  while (this->time() < end)
  {
    this->tick();
  }
}

void VirtualRun::tick()
{
  const double time = this->time();
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < this->hands(); ++i)
  {
    this->Samples[i] = this->Hands[i]->read(time);
  }
  this->Step.step(this->Samples.data(), time, this->Newest.data());
  for (std::size_t i = 0; i < this->hands(); ++i)
  {
    this->Hands[i]->writeWrench(this->Newest[i].wrench());
  }
  const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - begin;
  // Retired scenes are freed here, which is not part of the measured time of the tick.
  this->Step.takeRetired();
  for (std::size_t i = 0; i < this->hands(); ++i)
  {
    this->keep(i, this->Newest[i]);
  }
  if (this->KeepsAll)
  {
    this->Nanoseconds.push_back(spent.count());
  }
}

RealTimeRun::RealTimeRun(
  SessionHands hands, ServoStep servo, const ServoLoopSettings& settings, const TicksKept& kept)
  : SessionRun(std::move(hands), settings.rate, kept)
  , Loop(pointersTo(this->Hands), std::move(servo), settings)
{
}

void RealTimeRun::change(std::unique_ptr<ServoScene> scene)
{
  this->Loop.changeScene(std::move(scene));
}

const Tick& RealTimeRun::newest(std::size_t hand)
{
  this->collect(); // reads the ticks at the display rate, so that the ring buffer does not fill
  return this->Loop.newest(hand);
}

void RealTimeRun::collect()
{
  this->Loop.freeScenes();
  for (std::size_t i = 0; i < this->hands(); ++i)
  {
    this->Loop.drain([this, i](const Tick& tick) { this->keep(i, tick); }, i);
  }
}
} // namespace palpate
