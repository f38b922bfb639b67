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
 * and clutch → contact (SceneSwitch) → safety chain → force on the device. For ServoLoop, or for a
 * loop of the caller.
 *
 * Body, tool, material and settings may change while the tip is in contact: change() passes on
 * another scene, and the force changes to it within 50 ms.
 *
 * If the device reports the orientation of the tool, the contact is that of a tool along this axis.
 * There is then a torque, which is sent to a device that outputs torque. An orientation that is not
 * finite makes a sample invalid. If the orientation is unknown, the tool is along the body's
 * normal, and the results are those of versions without tilt, to the bit. The clutch holds the tip,
 * not the axis: a decoupled hand still turns the tool.
 *
 * The force is exactly zero, in the same tick, if the sample is not valid or not finite, if the
 * force is not finite, if the device has been silent for too long, and while the step is stopped.
 * The contacts are then forgotten, and a ramp ends. The contacts are kept if readings are missing
 * for no longer than the device's time-out, see SafetyChain.
 *
 * step() and all other noexcept functions neither allocate, free, lock nor throw. All functions are
 * for one thread.
 */
class PALPATE_EXPORT ServoStep
{
public:
  /// Only two links of the safety chain are active, finiteness and magnitude
  /// (SafetySettings::magnitudeOnly). With a limit that is negative or NaN nothing is sent. The
  /// body must outlive the step.
  ServoStep(const ContactBody& body, const WorkspaceMapping& mapping, double maximumForce,
    const ContactSettings& settings = {});
  /// `scene` is not null. A mapping that has a fault() makes every sample invalid. The clutch is
  /// held while any of the bits `clutchButtons` of DeviceSample::buttons is set.
  ServoStep(std::unique_ptr<ServoScene> scene, const WorkspaceMapping& mapping,
    const SafetySettings& safety, std::uint32_t clutchButtons = 0);

  /// `time` in s must increase, for the ramps and the safety chain.
  Tick step(const DeviceSample& sample, double time) noexcept;

  /// Call it after the force is sent and before the loop waits: prefetches the memory that the next
  /// step reads if the hand continues its motion. Changes nothing, and may be left out.
  void foresee() const noexcept { this->Scenes.foresee(); }
  /// Call it shortly before the next sample is read: returns the result of step() for a likely
  /// sample. It uses copies of contact, clutch and safety chain, and brings the data and code of a
  /// step into the caches. Changes nothing; may be left out. Costs as much as a step.
  Tick rehearse(const DeviceSample& likely, double time) const noexcept;

  /// Changes to another scene; null changes nothing. See SceneSwitch.
  void change(std::unique_ptr<ServoScene> next) noexcept { this->Scenes.change(std::move(next)); }
  /// Whether a ramp is under way or about to begin.
  bool isSwitching() const noexcept { return this->Scenes.isSwitching(); }
  /// The scenes no longer needed, as a list (ServoScene::next), or null. Free them outside of the
  /// tick. Those not taken are freed with the step.
  std::unique_ptr<ServoScene> takeRetired() noexcept { return this->Scenes.takeRetired(); }

  /// No force from the next step on, until start().
  void stop() noexcept;
  void start() noexcept { this->End.start(); }
  /// Starts again: forgets contacts, ramp, clutch and the history of the safety chain. A stopped
  /// step stays stopped.
  void reset() noexcept;

  const WorkspaceMapping& mapping() const noexcept { return this->End.mapping(); }
  /// As given; the force factor of the scene applies in addition.
  const SafetySettings& safety() const noexcept { return this->End.safety(); }
  /// The energy that the hand has put in and not got back, J, as the safety chain observes it.
  double energy() const noexcept { return this->End.energy(); }

private:
  /// Time since the last step, s; 0 if the time does not increase.
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
