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

/// Whether the force was ended, not changed.
bool isLost(const SafeForce& safe) noexcept
{
  return !safe.isGap &&
    (safe.has(SafetyLink::NotFinite) || safe.has(SafetyLink::Watchdog) ||
      safe.has(SafetyLink::NoSample) || safe.has(SafetyLink::Stopped));
}
} // namespace

ServoStep::ServoStep(const ContactBody& body, const WorkspaceMapping& mapping, double maximumForce,
  const ContactSettings& settings)
  : ServoStep(sceneOf(body, settings), mapping, SafetySettings::magnitudeOnly(maximumForce))
{
}

ServoStep::ServoStep(std::unique_ptr<ServoScene> scene, const WorkspaceMapping& mapping,
  const SafetySettings& safety, std::uint32_t clutchButtons)
  : Mapping(mapping)
  , Chain(safety)
  , Safety(Chain.settings())
  , Hand(clutchButtons)
  , Scenes(std::move(scene))
  , Limits{ Chain.bodyStiffnessLimit(mapping.scale()), Chain.bodyTorsionalLimit(mapping.scale()) }
  , IsSound(!mapping.fault())
  , LastTime(NotANumber)
{
}

Tick ServoStep::step(const DeviceSample& sample, double time) noexcept
{
  const double elapsed = time > this->LastTime ? time - this->LastTime : 0.0;
  this->LastTime = std::isfinite(time) ? time : this->LastTime;
  Tick tick;
  tick.time = time;
  tick.buttons = sample.buttons;
  tick.contact.state = ContactState::Invalid;
  SafetyInput input;
  input.time = time;
  input.fresh = sample.fresh;
  input.position = this->Mapping.inReach(sample.position);
  if (this->IsSound && sample.valid && input.position.allFinite() &&
    sample.orientation.coeffs().allFinite())
  {
    tick.tip = this->Mapping.toBody(input.position);
    tick.valid = tick.tip.allFinite();
  }
  if (tick.valid)
  {
    tick.fresh = sample.fresh;
    tick.velocity = this->Mapping.velocityToBody(sample.velocity);
    if (isTold(sample.orientation))
    {
      input.orientation = sample.orientation;
      tick.axis = this->Mapping.axisToBody(shaftOf(sample.orientation));
    }
    this->touch(elapsed, tick, input);
  }
  else
  {
    this->Scenes.pass(elapsed);
  }
  input.valid = tick.valid;
  const SafeForce safe = this->Chain.apply(input);
  tick.deviceForce = safe.force;
  tick.appliedForce = this->Mapping.forceToBody(safe.force);
  tick.deviceTorque = safe.torque;
  if (this->Chain.hasTorque())
  {
    tick.appliedTorque = this->Mapping.torqueToBody(safe.torque);
  }
  tick.forceFactor = safe.forceFactor;
  tick.holdTime = safe.holdTime;
  tick.acted = safe.acted;
  tick.scene = this->Scenes.changes();
  if (isLost(safe))
  {
    this->Scenes.forget();
  }
  return tick;
}

void ServoStep::touch(double elapsed, Tick& tick, SafetyInput& input) noexcept
{
  const double held = this->Hand.forceShare();
  tick.tip = this->Hand.follow(tick.tip, tick.buttons, elapsed);
  tick.clutched = this->Hand.isHeld();
  const double share = this->Hand.forceShare();

  const ToolPose pose = tick.hasAxis() ? ToolPose(tick.tip, tick.axis) : ToolPose(tick.tip);
  const SceneForce felt = this->Scenes.update(pose, elapsed, this->Limits);
  tick.contact = felt.contact;
  tick.sceneShare = felt.share;
  tick.idealForce = share * felt.idealForce;
  this->Chain.setForceFactor(this->Safety.forceFactor * felt.forceFactor);
  input.outside = felt.outside;
  input.idealForce = this->Mapping.forceToDevice(tick.idealForce);
  input.cappedForce = this->Mapping.forceToDevice(share * felt.cappedForce);
  tick.idealTorque = share * felt.idealTorque;
  input.idealTorque = this->Mapping.torqueToDevice(tick.idealTorque);
  input.cappedTorque = this->Mapping.torqueToDevice(share * felt.cappedTorque);
  input.depth = this->Mapping.lengthToDevice(felt.reach);
  input.changing = felt.changing || share > held;
}

void ServoStep::stop() noexcept
{
  this->Chain.stop();
  this->Scenes.forget();
}

void ServoStep::reset() noexcept
{
  this->Chain.reset();
  this->Hand.reset();
  this->Scenes.reset();
  this->LastTime = NotANumber;
}
} // namespace palpate
