// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ServoStep_h
#define palpate_ServoStep_h

#include "Mechanics/PalpateExport.h"
#include "Haptics/Servo/DeviceEnd.h"
#include "Haptics/Servo/SceneSwitch.h"
#include "Contact/ToolContact.h"

#include <cstdint>
#include <memory>

namespace palpate
{
/**
 * One step of the servo loop, as a plain function of a sample and a time: device sample → mapping
 * and clutch → contact (SceneSwitch) → safety chain → force on the device. For a loop of our own or
 * of somebody else's.
 *
 * Body, tool, material and settings may change while the tip is in contact: change() hands over
 * another scene, to which the force goes over within 50 ms.
 *
 * Where the device tells how the tool is turned, the contact is that of a tool along that axis, and
 * there is a torque, which a device that outputs one is sent; an orientation that is not finite
 * makes a sample invalid. Otherwise the tool stands along the body's normal, and all is as it was
 * before there were tilts, to the bit. The clutch holds the tip, not the axis: a hand that is off
 * it turns the tool.
 *
 * The force is zero, exactly and in the same tick, for a sample that is not valid or not finite,
 * for a force that is not finite, a device that has been silent for too long, and while stopped.
 * The contacts are then forgotten, and a ramp is over; but not where readings are missing for no
 * longer than the device's time-out, see SafetyChain.
 *
 * step() and all that is noexcept neither allocate, free, lock nor throw, and are for one thread.
 */
class PALPATE_EXPORT ServoStep
{
public:
  /// Of the safety chain only finiteness and magnitude (SafetySettings::magnitudeOnly): a limit
  /// that is negative or NaN sends nothing. The body must outlive the step.
  ServoStep(const ContactBody& body, const WorkspaceMapping& mapping, double maximumForce,
    const ContactSettings& settings = {});
  /// `scene` is not null. A mapping that has a fault() makes every sample invalid. The clutch is at
  /// work while any of `clutchButtons`, bits of DeviceSample::buttons, is down.
  ServoStep(std::unique_ptr<ServoScene> scene, const WorkspaceMapping& mapping,
    const SafetySettings& safety, std::uint32_t clutchButtons = 0);

  /// `time` in s; ramps and the chain need one that increases.
  Tick step(const DeviceSample& sample, double time) noexcept;

  /// For when the force is sent, before the loop waits: asks for the memory which the next step
  /// reads if the hand moves on as it did. Changes nothing, and may be left out.
  void foresee() const noexcept { this->Scenes.foresee(); }
  /// For the last moments before the next sample is read: what step() would return for a sample
  /// that is likely to come, made on copies of contact, clutch and safety chain, so that what it
  /// reads, code too, is at hand then. Changes nothing; may be left out. Costs a step.
  Tick rehearse(const DeviceSample& likely, double time) const noexcept;

  /// Hands over another scene; null: nothing happens. See SceneSwitch.
  void change(std::unique_ptr<ServoScene> next) noexcept { this->Scenes.change(std::move(next)); }
  /// Whether a ramp is under way or about to begin.
  bool isSwitching() const noexcept { return this->Scenes.isSwitching(); }
  /// The scenes no longer needed, as a list (ServoScene::next), or null: to be freed outside of the
  /// tick. Those not taken are freed with the step.
  std::unique_ptr<ServoScene> takeRetired() noexcept { return this->Scenes.takeRetired(); }

  /// No force from the next step on, until start().
  void stop() noexcept;
  void start() noexcept { this->End.start(); }
  /// Begins anew: contacts, ramp, clutch and what the chain has seen are forgotten. What is stopped
  /// stays stopped.
  void reset() noexcept;

  const WorkspaceMapping& mapping() const noexcept { return this->End.mapping(); }
  /// As given; the scene's factor comes on top.
  const SafetySettings& safety() const noexcept { return this->End.safety(); }
  /// What the hand has put in and not got back, J, as the chain observes it.
  double energy() const noexcept { return this->End.energy(); }

private:
  /// s; 0 where the time does not increase.
  double since(double time) const noexcept
  {
    return time > this->LastTime ? time - this->LastTime : 0.0;
  }

  DeviceEnd End;
  SceneSwitch Scenes;
  double LastTime; ///< NaN: none
};
} // namespace palpate

#endif
