// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/DeviceEnd.h"

namespace palpate
{
namespace
{
/// Whether the force was ended, not only changed. False in a gap, because the contact continues
/// after a gap.
bool isLost(const SafeForce& safe) noexcept
{
  return !safe.isGap &&
    (safe.has(SafetyLink::NotFinite) || safe.has(SafetyLink::Watchdog) ||
      safe.has(SafetyLink::NoSample) || safe.has(SafetyLink::Stopped));
}
} // namespace

DeviceEnd::DeviceEnd(const WorkspaceMapping& mapping, const SafetySettings& safety,
  std::uint32_t clutchButtons) noexcept
  : Mapping(mapping)
  , Chain(safety)
  , Safety(Chain.settings())
  , Hand(clutchButtons)
  , Limits{ Chain.bodyStiffnessLimit(mapping.scale()), Chain.bodyTorsionalLimit(mapping.scale()) }
  , IsSound(!mapping.fault())
{
}

[[gnu::hot]] void DeviceEnd::read(
  const DeviceSample& sample, double time, Tick& tick, SafetyInput& input) noexcept
{
  tick.time = time;
  tick.buttons = sample.buttons;
  tick.contact.state = ContactState::Invalid;
  input.time = time;
  input.fresh = sample.fresh;
  input.position = this->Mapping.inReach(sample.position);
  if (this->IsSound && sample.valid && input.position.allFinite() &&
    sample.orientation.coeffs().allFinite())
  {
    tick.tip = this->Mapping.toBody(input.position);
    tick.valid = tick.tip.allFinite();
  }
  input.valid = tick.valid;
  if (!tick.valid)
  {
    return;
  }
  tick.fresh = sample.fresh;
  tick.velocity = this->Mapping.velocityToBody(sample.velocity);
  if (isTold(sample.orientation))
  {
    input.orientation = sample.orientation;
    tick.axis = this->Mapping.axisToBody(shaftOf(sample.orientation));
  }
}

[[gnu::hot]] ToolPose DeviceEnd::follow(double elapsed, Tick& tick) noexcept
{
  this->Held = this->Hand.forceShare();
  tick.tip = this->Hand.follow(tick.tip, tick.buttons, elapsed);
  tick.clutched = this->Hand.isHeld();
  return tick.hasAxis() ? ToolPose(tick.tip, tick.axis) : ToolPose(tick.tip);
}

[[gnu::hot]] void DeviceEnd::feel(const SceneForce& felt, Tick& tick, SafetyInput& input) noexcept
{
  const double share = this->Hand.forceShare();
  tick.contact = felt.contact;
  tick.sceneShare = felt.share;
  tick.idealForce = share * felt.idealForce;
  this->Chain.setForceFactor(this->Safety.forceFactor * felt.forceFactor);
  input.outside = felt.outside;
  input.idealForce = this->Mapping.forceToDevice(tick.idealForce);
  input.cappedForce = this->Mapping.forceToDevice(share * felt.cappedForce);
  tick.idealTorque = share * felt.idealTorque;
  if (this->Chain.hasTorque())
  {
    input.idealTorque = this->Mapping.torqueToDevice(tick.idealTorque);
    input.cappedTorque = this->Mapping.torqueToDevice(share * felt.cappedTorque);
  }
  input.depth = this->Mapping.lengthToDevice(felt.reach);
  input.changing = felt.changing || share > this->Held;
}

[[gnu::hot]] bool DeviceEnd::send(const SafetyInput& input, Tick& tick) noexcept
{
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
  return isLost(safe);
}

void DeviceEnd::reset() noexcept
{
  this->Chain.reset();
  this->Hand.reset();
}
} // namespace palpate
