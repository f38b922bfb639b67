// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/ServoStep.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace palpate
{
namespace
{
/// Makes a scene for a body that the caller owns.
std::unique_ptr<ServoScene> sceneOf(const ContactBody& body, const ContactSettings& settings)
{
  const std::shared_ptr<void> nobody;
  return std::make_unique<ServoScene>(std::shared_ptr<const ContactBody>(nobody, &body), settings);
}

std::unique_ptr<ServoScene> sceneFor(std::unique_ptr<ServoScene> scene, std::size_t hands)
{
  return scene->contacts.count() == hands
    ? std::move(scene)
    : std::make_unique<ServoScene>(scene->body, scene->settings, scene->forceFactor, hands);
}
} // namespace

ServoStep::ServoStep(const ContactBody& body, const WorkspaceMapping& mapping, double maximumForce,
  const ContactSettings& settings)
  : ServoStep(sceneOf(body, settings), mapping, SafetySettings::magnitudeOnly(maximumForce))
{
}

ServoStep::ServoStep(std::unique_ptr<ServoScene> scene, const WorkspaceMapping& mapping,
  const SafetySettings& safety, std::uint32_t clutchButtons)
  : ServoStep(std::move(scene), { Hand{ mapping, safety, clutchButtons } })
{
}

ServoStep::ServoStep(std::unique_ptr<ServoScene> scene, const std::vector<Hand>& hands)
  : Poses(std::clamp<std::size_t>(hands.size(), 1, Most))
  , Scenes(sceneFor(std::move(scene), Poses.size()))
  , LastTime(NotANumber)
{
  for (std::size_t i = 0; i < std::min(hands.size(), Most); ++i)
  {
    this->Devices.push_back(
      { DeviceEnd(hands[i].mapping, hands[i].safety, hands[i].clutchButtons), {} });
  }
  this->Rehearsed = this->Devices;
}

Tick ServoStep::step(const DeviceSample& sample, double time) noexcept
{
  Tick tick;
  this->makeStep(&sample, time, &tick);
  return tick;
}

void ServoStep::step(const DeviceSample* samples, double time, Tick* ticks) noexcept
{
  std::fill_n(ticks, this->count(), Tick());
  this->makeStep(samples, time, ticks);
}

Tick ServoStep::rehearse(const DeviceSample& likely, double time) noexcept
{
  Tick tick;
  this->makeRehearsal(&likely, time, &tick);
  return tick;
}

void ServoStep::rehearse(const DeviceSample* likely, double time, Tick* ticks) noexcept
{
  std::fill_n(ticks, this->count(), Tick());
  this->makeRehearsal(likely, time, ticks);
}

void ServoStep::makeStep(const DeviceSample* samples, double time, Tick* ticks) noexcept
{
  const double elapsed = this->since(time);
  this->LastTime = std::isfinite(time) ? time : this->LastTime;
  const std::size_t over = this->makeTicks(this->Devices, samples, time, elapsed, ticks);
  if (over == this->count())
  {
    this->Scenes.forget();
    return;
  }
  for (std::size_t i = 0; over > 0 && i < this->count(); ++i)
  {
    if (this->Devices[i].isOver)
    {
      this->Scenes.forget(i);
    }
  }
}

void ServoStep::makeRehearsal(const DeviceSample* likely, double time, Tick* ticks) noexcept
{
  this->Rehearsed = this->Devices;
  this->makeTicks(this->Rehearsed, likely, time, this->since(time), ticks);
}

// A rehearsal must load the code of the tick itself into the caches. Therefore this code is one
// function and is never inlined.
[[gnu::hot, gnu::noinline]] std::size_t ServoStep::makeTicks(std::vector<Device>& devices,
  const DeviceSample* samples, double time, double elapsed, Tick* ticks) noexcept
{
  const std::size_t count = devices.size();
  const bool isRehearsal = &devices == &this->Rehearsed;
  SceneSwitch& scenes = this->Scenes;
  std::optional<ToolPose>* const poses = this->Poses.data();
  const SafetyInput none;
  for (std::size_t i = 0; i < count; ++i)
  {
    DeviceEnd& end = devices[i].end;
    poses[i].reset();
    devices[i].input = none;
    end.read(samples[i], time, ticks[i], devices[i].input);
    if (ticks[i].valid)
    {
      const ToolPose pose = end.follow(elapsed, ticks[i]);
      // A single hand is followed even while its force has ended.
      if (count == 1 || !end.isEnded(time))
      {
        poses[i].emplace(pose);
      }
    }
  }
  isRehearsal ? scenes.rehearse(poses, elapsed) : scenes.update(poses, elapsed);
  for (std::size_t i = 0; i < count; ++i)
  {
    DeviceEnd& end = devices[i].end;
    devices[i].sharesEnergy = devices[i].isAtWork && poses[i];
    if (poses[i])
    {
      end.feel(isRehearsal ? scenes.rehearsedForce(i, *poses[i], end.limits())
                           : scenes.force(i, *poses[i], end.limits()),
        ticks[i], devices[i].input);
    }
  }
  if (count > 1 && scenes.isCoupled())
  {
    shareEnergy(devices);
  }
  constexpr auto shut = static_cast<std::uint16_t>(SafetyLink::Gate);
  std::size_t over = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    Device& device = devices[i];
    Tick& tick = ticks[i];
    tick.scene = scenes.changes();
    device.isOver = device.end.send(device.input, tick);
    device.isAtWork = !device.isOver && tick.valid && (tick.acted & shut) == 0;
    over += device.isOver ? 1 : 0;
  }
  return over;
}

void ServoStep::shareEnergy(std::vector<Device>& devices) noexcept
{
  // Returns twice the energy that a linear scene stores at a hand, J.
  const auto held = [](const Device& device)
  { return device.sharesEnergy ? device.input.idealForce.norm() * device.input.depth : 0.0; };
  const auto spareOf = [](const Device& device)
  { return device.sharesEnergy ? device.end.spareEnergy() : 0.0; };
  double energy = 0.0;
  double all = 0.0;
  for (const Device& device : devices)
  {
    energy += device.sharesEnergy ? device.end.energy() : 0.0;
    all += held(device);
  }
  if (!(all > 0.0) || !std::isfinite(all))
  {
    return;
  }
  double pool = 0.0;
  double wanted = 0.0;
  for (Device& device : devices)
  {
    const double spare = spareOf(device);
    const double needed = device.end.energy() - spare;
    device.wanted = device.sharesEnergy ? std::max(0.0, energy * held(device) / all - needed) : 0.0;
    pool += spare;
    wanted += device.wanted;
  }
  for (Device& device : devices)
  {
    if (wanted > 0.0)
    {
      device.end.transferEnergy(pool * (device.wanted / wanted) - spareOf(device));
    }
  }
}

void ServoStep::stop() noexcept
{
  for (std::size_t i = 0; i < this->count(); ++i)
  {
    this->stop(i);
  }
  this->Scenes.forget();
}

void ServoStep::start() noexcept
{
  for (Device& device : this->Devices)
  {
    device.end.start();
  }
}

void ServoStep::stop(std::size_t hand) noexcept
{
  this->Devices[hand].end.stop();
  this->Devices[hand].isAtWork = false;
  this->Scenes.forget(hand);
}

void ServoStep::reset() noexcept
{
  for (Device& device : this->Devices)
  {
    device.end.reset();
    device.isAtWork = false;
  }
  this->Scenes.reset();
  this->LastTime = NotANumber;
}
} // namespace palpate
