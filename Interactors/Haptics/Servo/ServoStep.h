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
 * One step of the servo loop, as a function of a sample and a time: device sample → mapping and
 * clutch → contact (SceneSwitch) → safety chain → force on the device. It is used by ServoLoop, or
 * by a loop of the caller.
 *
 * Body, tool, material and settings may change while the tip is in contact: change() passes another
 * scene, and the force changes to that of the new scene within 50 ms.
 *
 * If the device reports the orientation of the tool, the contact is that of a tool along this axis.
 * There is then a torque, which is sent to a device that outputs torque. An orientation that is not
 * finite makes a sample invalid. If the orientation is unknown, the tool is along the body's
 * normal, and the results are bit for bit those of versions without tilt. The clutch stops the tip,
 * not the axis: a decoupled hand still turns the tool.
 *
 * The force is exactly zero, in the same tick, if the sample is not valid or not finite, if the
 * force is not finite, if the device has sent no reading for longer than its time-out, and while
 * the step is stopped. The contacts then end, and so does a ramp. The contacts are kept if readings
 * are missing for no longer than the device's time-out, see SafetyChain.
 *
 * step() and all other noexcept functions neither allocate, free, lock nor throw. All functions are
 * for one thread.
 */
class PALPATE_EXPORT ServoStep
{
public:
  /// Only two links of the safety chain are active, finiteness and magnitude
  /// (SafetySettings::magnitudeOnly). If the limit is negative or NaN, no force is sent. The body
  /// must outlive the step.
  ServoStep(const ContactBody& body, const WorkspaceMapping& mapping, double maximumForce,
    const ContactSettings& settings = {});
  /// `scene` must not be null. A mapping that has a fault() makes every sample invalid. The clutch
  /// is held while any of the bits `clutchButtons` of DeviceSample::buttons is set.
  ServoStep(std::unique_ptr<ServoScene> scene, const WorkspaceMapping& mapping,
    const SafetySettings& safety, std::uint32_t clutchButtons = 0);

  /// Makes a step. `time` in s must increase, for the ramps and the safety chain.
  Tick step(const DeviceSample& sample, double time) noexcept;

  /// Prefetches the memory that the next step reads if the hand continues its motion. To be called
  /// after the force is sent and before the loop waits; optional. Changes nothing.
  void foresee() const noexcept { this->Scenes.foresee(); }
  /// Returns the result that step() would have for a likely sample. It uses copies of contact,
  /// clutch and safety chain, and loads the data and code of a step into the caches. To be called
  /// shortly before the next sample is read; optional. Changes nothing; costs as much as a step.
  Tick rehearse(const DeviceSample& likely, double time) const noexcept;

  /// Changes to another scene; null has no effect. See SceneSwitch.
  void change(std::unique_ptr<ServoScene> next) noexcept { this->Scenes.change(std::move(next)); }
  /// Whether a ramp is active or about to begin.
  bool isSwitching() const noexcept { return this->Scenes.isSwitching(); }
  /// The scenes that are no longer needed, as a list (ServoScene::next), or null. They must be
  /// freed outside the tick. Scenes that are not taken are freed with the step.
  std::unique_ptr<ServoScene> takeRetired() noexcept { return this->Scenes.takeRetired(); }

  /// Ends the force from the next step until start().
  void stop() noexcept;
  void start() noexcept { this->End.start(); }
  /// Resets contacts, ramp, clutch and the history of the safety chain. A stopped step remains
  /// stopped.
  void reset() noexcept;

  const WorkspaceMapping& mapping() const noexcept { return this->End.mapping(); }
  /// The settings given to the constructor; the force factor of the scene applies in addition.
  const SafetySettings& safety() const noexcept { return this->End.safety(); }
  /// The energy that the hand has put in and not received back, J, as observed by the safety chain.
  double energy() const noexcept { return this->End.energy(); }

private:
  /// Time since the last step, s; 0 if the time does not increase.
  double since(double time) const noexcept
  {
    return time > this->LastTime ? time - this->LastTime : 0.0;
  }

  DeviceEnd End;
  SceneSwitch Scenes;
  double LastTime; ///< NaN: there was no step yet
};
} // namespace palpate

#endif
