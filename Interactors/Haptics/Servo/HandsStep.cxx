// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/HandsStep.h"

#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
/// The pose of a hand that has no effect on the scene.
ToolPose absentPose() noexcept
{
  return ToolPose(Vector3::Constant(NotANumber));
}

bool isFor(const ServoScene& scene, std::size_t hands) noexcept
{
  return scene.together && scene.together->count() == hands;
}

std::unique_ptr<ServoScene> sceneFor(std::unique_ptr<ServoScene> scene, std::size_t hands)
{
  return isFor(*scene, hands)
    ? std::move(scene)
    : std::make_unique<ServoScene>(scene->body, scene->settings, scene->forceFactor, hands);
}
} // namespace

HandsStep::HandsStep(std::unique_ptr<ServoScene> scene, const std::vector<Hand>& hands)
  : LastTime(NotANumber)
{
  const std::size_t count = std::min(hands.size(), Most);
  this->Ends.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Ends.emplace_back(hands[i].mapping, hands[i].safety, hands[i].clutchButtons);
  }
  this->Ticks.resize(count);
  this->Inputs.resize(count);
  this->AtWork.resize(count);
  this->Wanted.resize(count);
  const std::size_t contacts = std::max<std::size_t>(count, 1);
  this->Poses.assign(contacts, absentPose());
  this->Current = sceneFor(std::move(scene), contacts);
}

const std::vector<Tick>& HandsStep::step(const DeviceSample* samples, double time) noexcept
{
  const double elapsed = time > this->LastTime ? time - this->LastTime : 0.0;
  this->LastTime = std::isfinite(time) ? time : this->LastTime;
  if (this->Waiting && this->Fade.share() == 0.0)
  {
    this->take();
  }
  this->read(samples, time, elapsed);
  this->feelAll(elapsed);
  if (this->Current->body->coupling)
  {
    this->shareEnergy();
  }
  constexpr auto shut = static_cast<std::uint16_t>(SafetyLink::Gate);
  for (std::size_t i = 0; i < this->Ends.size(); ++i)
  {
    Tick& tick = this->Ticks[i];
    tick.scene = this->Changes;
    const bool isOver = this->Ends[i].send(this->Inputs[i], tick);
    this->AtWork[i] = !isOver && tick.valid && (tick.acted & shut) == 0;
    if (isOver)
    {
      this->Current->together->lose(i);
    }
  }
  return this->Ticks;
}

void HandsStep::feelAll(double elapsed) noexcept
{
  const double faded = this->Fade.share();
  const double share = this->Fade.advance(this->Waiting ? 0.0 : 1.0, elapsed);
  const std::vector<Contact>& felt = this->Current->together->update(this->Poses.data(), elapsed);
  for (std::size_t i = 0; i < this->Ends.size(); ++i)
  {
    if (!this->Poses[i].tip.allFinite())
    {
      continue;
    }
    SceneForce force = this->feel(i, felt[i]);
    force.changing = share > faded;
    force.idealForce *= share;
    force.cappedForce *= share;
    force.idealTorque *= share;
    force.cappedTorque *= share;
    this->Ends[i].feel(force, this->Ticks[i], this->Inputs[i]);
  }
}

void HandsStep::shareEnergy() noexcept
{
  // Twice the energy that a linear scene stores at each hand.
  const auto held = [this](std::size_t i)
  { return this->Inputs[i].idealForce.norm() * this->Inputs[i].depth; };
  const auto takesPart = [this](std::size_t i)
  { return this->AtWork[i] != 0 && this->Poses[i].tip.allFinite(); };
  double energy = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < this->Ends.size(); ++i)
  {
    energy += takesPart(i) ? this->Ends[i].energy() : 0.0;
    all += takesPart(i) ? held(i) : 0.0;
  }
  if (!(all > 0.0) || !std::isfinite(all))
  {
    return;
  }
  double pool = 0.0;
  double wanted = 0.0;
  for (std::size_t i = 0; i < this->Ends.size(); ++i)
  {
    const double spare = takesPart(i) ? this->Ends[i].spareEnergy() : 0.0;
    const double needed = this->Ends[i].energy() - spare;
    this->Wanted[i] = takesPart(i) ? std::max(0.0, energy * held(i) / all - needed) : 0.0;
    pool += spare;
    wanted += this->Wanted[i];
  }
  for (std::size_t i = 0; wanted > 0.0 && i < this->Ends.size(); ++i)
  {
    const double spare = takesPart(i) ? this->Ends[i].spareEnergy() : 0.0;
    this->Ends[i].transferEnergy(pool * (this->Wanted[i] / wanted) - spare);
  }
}

void HandsStep::read(const DeviceSample* samples, double time, double elapsed) noexcept
{
  for (std::size_t i = 0; i < this->Ends.size(); ++i)
  {
    Tick& tick = this->Ticks[i];
    tick = Tick();
    this->Inputs[i] = SafetyInput();
    this->Poses[i] = absentPose();
    this->Ends[i].read(samples[i], time, tick, this->Inputs[i]);
    if (!tick.valid)
    {
      continue;
    }
    const ToolPose pose = this->Ends[i].follow(elapsed, tick);
    if (!this->Ends[i].isEnded(time))
    {
      this->Poses[i] = pose;
    }
  }
}

SceneForce HandsStep::feel(std::size_t hand, const Contact& contact) noexcept
{
  const StiffnessLimits& limits = this->Ends[hand].limits();
  const bool isCapped = contact.normalForce > 0.0 && !std::isinf(limits.straight);
  const double share = isCapped
    ? this->Current->together->cappedShare(hand, limits.straight / this->Current->forceFactor)
    : 1.0;
  SceneForce felt = forceOf(*this->Current, contact, share, this->Poses[hand], limits);
  felt.reach += this->Current->together->sunk(hand);
  return felt;
}

bool HandsStep::change(std::unique_ptr<ServoScene> next) noexcept
{
  if (!next)
  {
    return false;
  }
  const bool isTaken = isFor(*next, this->Ends.size());
  if (isTaken)
  {
    std::swap(this->Waiting, next);
  }
  this->retire(std::move(next));
  return isTaken;
}

void HandsStep::take() noexcept
{
  this->retire(std::move(this->Current));
  this->Current = std::move(this->Waiting);
  ++this->Changes;
}

void HandsStep::retire(std::unique_ptr<ServoScene> scene) noexcept
{
  if (scene)
  {
    scene->next = std::move(this->Retired);
    this->Retired = std::move(scene);
  }
}

void HandsStep::stop() noexcept
{
  for (std::size_t i = 0; i < this->Ends.size(); ++i)
  {
    this->stop(i);
  }
}

void HandsStep::start() noexcept
{
  for (DeviceEnd& end : this->Ends)
  {
    end.start();
  }
}

void HandsStep::stop(std::size_t hand) noexcept
{
  this->Ends[hand].stop();
  this->AtWork[hand] = 0;
  this->Current->together->lose(hand);
}

void HandsStep::reset() noexcept
{
  for (DeviceEnd& end : this->Ends)
  {
    end.reset();
  }
  if (this->Waiting)
  {
    this->take();
  }
  this->Current->together->reset();
  this->Fade = ForceRamp(1.0);
  std::fill(this->AtWork.begin(), this->AtWork.end(), char{ 0 });
  this->LastTime = NotANumber;
}
} // namespace palpate
