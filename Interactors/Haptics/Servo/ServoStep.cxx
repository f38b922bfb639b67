// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/ServoStep.h"
#include "Mechanics/Numerics/Constants.h"

#include <cmath>

namespace palpate
{
namespace
{
/// A scene of a body that somebody else keeps alive.
std::unique_ptr<ServoScene> sceneOf(const ContactBody& body, const ContactSettings& settings)
{
  const std::shared_ptr<void> nobody;
  return std::make_unique<ServoScene>(std::shared_ptr<const ContactBody>(nobody, &body), settings);
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
  const double elapsed = time > this->LastTime ? time - this->LastTime : 0.0;
  this->LastTime = std::isfinite(time) ? time : this->LastTime;
  Tick tick;
  SafetyInput input;
  this->End.read(sample, time, tick, input);
  if (tick.valid)
  {
    const ToolPose pose = this->End.follow(elapsed, tick);
    this->End.feel(this->Scenes.update(pose, elapsed, this->End.limits()), tick, input);
  }
  else
  {
    this->Scenes.pass(elapsed);
  }
  const bool isOver = this->End.send(input, tick);
  tick.scene = this->Scenes.changes();
  if (isOver)
  {
    this->Scenes.forget();
  }
  return tick;
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
