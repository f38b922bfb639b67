// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Session/SessionRun.h"

#include <array>
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

VirtualRun::VirtualRun(
  std::shared_ptr<HapticDevice> hand, ServoStep servo, double rate, const TicksKept& kept)
  : SessionRun({ std::move(hand) }, rate, kept)
  , Step(std::move(servo))
  , Period(1.0 / rate)
  , Newest(1)
{
}

VirtualRun::VirtualRun(SessionHands hands, HandsStep servo, double rate, const TicksKept& kept)
  : SessionRun(std::move(hands), rate, kept)
  , JointStep(std::move(servo))
  , Period(1.0 / rate)
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
  if (this->Step)
  {
    this->Step->change(std::move(scene));
  }
  else
  {
    this->JointStep->change(std::move(scene));
  }
}

double VirtualRun::time() const
{
  return static_cast<double>(this->ticksMade()) * this->Period;
}

void VirtualRun::step(double seconds)
{
  // The tolerance of half a tick ensures that steps which add up to a whole number of ticks run
  // exactly that number.
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
  if (this->Step)
  {
    this->Newest[0] = this->Step->step(this->Hands[0]->read(time), time);
    this->Hands[0]->writeWrench(this->Newest[0].wrench());
  }
  else
  {
    this->stepAll(time);
  }
  const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - begin;
  // Retired scenes are freed here, outside of the measured time of the tick.
  this->Step ? this->Step->takeRetired() : this->JointStep->takeRetired();
  for (std::size_t i = 0; i < this->hands(); ++i)
  {
    this->keep(i, this->Newest[i]);
  }
  if (this->KeepsAll)
  {
    this->Nanoseconds.push_back(spent.count());
  }
}

void VirtualRun::stepAll(double time)
{
  std::array<DeviceSample, HandsStep::Most> samples;
  for (std::size_t i = 0; i < this->hands(); ++i)
  {
    samples[i] = this->Hands[i]->read(time);
  }
  this->Newest = this->JointStep->step(samples.data(), time);
  for (std::size_t i = 0; i < this->hands(); ++i)
  {
    this->Hands[i]->writeWrench(this->Newest[i].wrench());
  }
}

RealTimeRun::RealTimeRun(std::shared_ptr<HapticDevice> hand, ServoStep servo,
  const ServoLoopSettings& settings, const TicksKept& kept)
  : SessionRun({ std::move(hand) }, settings.rate, kept)
  , Loop(*this->Hands[0], std::move(servo), settings)
{
}

RealTimeRun::RealTimeRun(
  SessionHands hands, HandsStep servo, const ServoLoopSettings& settings, const TicksKept& kept)
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
  this->collect(); // reads the newest tick at display rate, so that the ring buffer does not fill
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
