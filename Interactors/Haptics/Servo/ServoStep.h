// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ServoStep_h
#define palpate_ServoStep_h

#include "Haptics/Devices/Clutch.h"
#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Safety/SafetyChain.h"
#include "Haptics/Servo/SceneSwitch.h"
#include "Contact/ToolContact.h"
#include "Haptics/Devices/WorkspaceMapping.h"

#include <cstdint>
#include <memory>

namespace palpate
{
/// What one step of the servo loop saw and did.
struct Tick
{
  double time = 0.0;                                     ///< s
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();         ///< body frame, mm
  Contact contact;                                       ///< body frame; the ideal force
  Eigen::Vector3d deviceForce = Eigen::Vector3d::Zero(); ///< device frame, N; what is sent

  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< of the hand, body frame, mm/s
  /// What enters the safety chain, body frame, N: contact.force, but blended while a scene is left
  /// for another, and less while the clutch is at work.
  Eigen::Vector3d idealForce = Eigen::Vector3d::Zero();
  Eigen::Vector3d appliedForce = Eigen::Vector3d::Zero(); ///< deviceForce, body frame, N
  /// Of the tool, body frame, unit, from tip to hand; zero where the device does not tell it.
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  /// As the forces, about the tip: device frame, N m; body frame, N mm.
  Eigen::Vector3d deviceTorque = Eigen::Vector3d::Zero();
  Eigen::Vector3d idealTorque = Eigen::Vector3d::Zero();
  Eigen::Vector3d appliedTorque = Eigen::Vector3d::Zero();
  double forceFactor = 1.0; ///< of applied over ideal force (DeviceFit)
  double holdTime = 0.0;    ///< s: for so long deviceForce may be held (SafetyChain)
  /// How much of idealForce is of the scene that `contact` tells of: less than 1 during a ramp.
  double sceneShare = 1.0;
  std::uint32_t scene = 0; ///< which that is: how many changes came before
  std::uint32_t buttons = 0;
  std::uint16_t acted = 0; ///< sum of SafetyLink
  bool valid = false;      ///< the device told where it is
  bool fresh = false;      ///< and not for the second time
  bool clutched = false;   ///< the tip stays while the hand moves

  bool hasAxis() const noexcept { return !this->axis.isZero(0.0); }
  /// What is sent.
  Wrench wrench() const noexcept { return { this->deviceForce, this->deviceTorque }; }
};

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

  /// Hands over another scene; null: nothing happens. See SceneSwitch.
  void change(std::unique_ptr<ServoScene> next) noexcept { this->Scenes.change(std::move(next)); }
  /// Whether a ramp is under way or about to begin.
  bool isSwitching() const noexcept { return this->Scenes.isSwitching(); }
  /// The scenes no longer needed, as a list (ServoScene::next), or null: to be freed outside of the
  /// tick. Those not taken are freed with the step.
  std::unique_ptr<ServoScene> takeRetired() noexcept { return this->Scenes.takeRetired(); }

  /// No force from the next step on, until start().
  void stop() noexcept;
  void start() noexcept { this->Chain.start(); }
  /// Begins anew: contacts, ramp, clutch and what the chain has seen are forgotten. What is stopped
  /// stays stopped.
  void reset() noexcept;

  const WorkspaceMapping& mapping() const noexcept { return this->Mapping; }
  /// As given; the scene's factor comes on top.
  const SafetySettings& safety() const noexcept { return this->Safety; }
  /// What the hand has put in and not got back, J, as the chain observes it.
  double energy() const noexcept { return this->Chain.energy(); }

private:
  void touch(double elapsed, Tick& tick, SafetyInput& input) noexcept;

  WorkspaceMapping Mapping;
  SafetyChain Chain;
  SafetySettings Safety;
  Clutch Hand;
  SceneSwitch Scenes;
  StiffnessLimits Limits; ///< for a scene of factor 1
  bool IsSound;           ///< the mapping
  double LastTime;        ///< NaN: none
};
} // namespace palpate

#endif
