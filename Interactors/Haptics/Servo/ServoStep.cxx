// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/ServoStep.h"
#include "Mechanics/Numerics/Constants.h"

#include <cmath>

namespace palpate
{
namespace
{
/// A scene of a body that the caller owns.
std::unique_ptr<ServoScene> sceneOf(const ContactBody& body, const ContactSettings& settings)
{
  const std::shared_ptr<void> nobody;
  return std::make_unique<ServoScene>(std::shared_ptr<const ContactBody>(nobody, &body), settings);
}
/// One tick of a device. `own` are the scenes to update, or null in a rehearsal. A rehearsal must
/// load the code of the tick itself into the caches; therefore this is one function and never
/// inlined.
[[gnu::hot, gnu::noinline]] Tick tickOf(DeviceEnd& end, const SceneSwitch& scenes, SceneSwitch* own,
  const DeviceSample& sample, double time, double elapsed, bool& isOver) noexcept
{
  Tick tick;
  SafetyInput input;
  end.read(sample, time, tick, input);
  if (tick.valid)
  {
    const ToolPose pose = end.follow(elapsed, tick);
    const SceneForce felt =
      own ? own->update(pose, elapsed, end.limits()) : scenes.rehearse(pose, elapsed, end.limits());
    end.feel(felt, tick, input);
  }
  else if (own)
  {
    own->pass(elapsed);
  }
  isOver = end.send(input, tick);
  return tick;
}
} // namespace

ServoStep::ServoStep(const ContactBody& body, const WorkspaceMapping& mapping, double maximumForce,
  const ContactSettings& settings)
  : ServoStep(sceneOf(body, settings), mapping, SafetySettings::magnitudeOnly(maximumForce))
{
}

ServoStep::ServoStep(std::unique_ptr<ServoScene> scene, const WorkspaceMapping& mapping,
  const SafetySettings& safety, std::uint32_t clutchButtons)
  : End(mapping, safety, clutchButtons)
  , Scenes(std::move(scene))
  , LastTime(NotANumber)
{
}

Tick ServoStep::step(const DeviceSample& sample, double time) noexcept
{
  const double elapsed = this->since(time);
  this->LastTime = std::isfinite(time) ? time : this->LastTime;
  bool isOver = false;
  Tick tick = tickOf(this->End, this->Scenes, &this->Scenes, sample, time, elapsed, isOver);
  tick.scene = this->Scenes.changes();
  if (isOver)
  {
    this->Scenes.forget();
  }
  return tick;
}

Tick ServoStep::rehearse(const DeviceSample& likely, double time) const noexcept
{
  DeviceEnd end(this->End);
  bool isOver = false;
  return tickOf(end, this->Scenes, nullptr, likely, time, this->since(time), isOver);
}

void ServoStep::stop() noexcept
{
  this->End.stop();
  this->Scenes.forget();
}

void ServoStep::reset() noexcept
{
  this->End.reset();
  this->Scenes.reset();
  this->LastTime = NotANumber;
}
} // namespace palpate
