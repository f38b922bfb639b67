// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DeviceEnd_h
#define palpate_DeviceEnd_h

#include "Haptics/Devices/HapticDevice.h"
#include "Haptics/Devices/WorkspaceMapping.h"
#include "Haptics/Safety/SafetyLinks.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Safety/SafetyChain.h"
#include "Haptics/Servo/SceneSwitch.h"
#include "Contact/Contact.h"

#include <Eigen/Core>

#include <cstdint>

namespace palpate
{
/// Input and result of one step of the servo loop.
struct Tick
{
  double time = 0.0;                             ///< s
  Eigen::Vector3d tip = Eigen::Vector3d::Zero(); ///< position of the tip, body frame, mm
  Contact contact;                               ///< contact with the ideal force, body frame
  Eigen::Vector3d deviceForce = Eigen::Vector3d::Zero(); ///< force that was sent, device frame, N

  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< velocity of the hand, body frame, mm/s
  /// Input of the safety chain, N, body frame. It is contact.force, but blended while the scene
  /// changes, and reduced while the clutch is held.
  Eigen::Vector3d idealForce = Eigen::Vector3d::Zero();
  Eigen::Vector3d appliedForce = Eigen::Vector3d::Zero(); ///< deviceForce in the body frame, N
  /// Axis of the tool, body frame, unit, from tip to hand; zero if the device does not report it.
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  /// Torques about the tip, corresponding to the forces above. deviceTorque is in the device frame,
  /// N m; the others are in the body frame, N mm.
  Eigen::Vector3d deviceTorque = Eigen::Vector3d::Zero();
  Eigen::Vector3d idealTorque = Eigen::Vector3d::Zero();
  Eigen::Vector3d appliedTorque = Eigen::Vector3d::Zero();
  /// Ratio of applied force to ideal force due to the device fit (DeviceFit).
  double forceFactor = 1.0;
  double holdTime = 0.0; ///< s, time for which deviceForce may be held (SafetyChain)
  /// Fraction of idealForce that comes from the scene of `contact`. It is less than 1 during a
  /// ramp.
  double sceneShare = 1.0;
  /// Index of the scene of `contact`, which is the number of preceding changes.
  std::uint32_t scene = 0;
  std::uint32_t buttons = 0;
  std::uint16_t acted = 0; ///< sum of SafetyLink
  bool valid = false;      ///< whether the device reported its position
  bool fresh = false;      ///< whether the sample is valid and new
  bool clutched = false; ///< whether the clutch is held: the tip does not move while the hand moves

  bool hasAxis() const noexcept { return !this->axis.isZero(0.0); }
  /// The force and torque that are sent to the device.
  Wrench wrench() const noexcept { return { this->deviceForce, this->deviceTorque }; }
};

/**
 * Decouples the hand from the tip, so that a small workspace suffices for a large body. While one
 * of the clutch buttons is held, the tip does not move and the hand moves freely. After the release
 * the tip follows the hand again with a constant offset, starting at its present position.
 *
 * The force fades to zero within 50 ms after the button is pressed and returns within 50 ms after
 * its release (ForceRamp), with or without contact. Therefore neither tip nor force jumps. A closed
 * gate remains closed, because the clutch does not move the tip out of the body.
 *
 * Positions are those of the tip, in the body frame, mm. No function allocates or throws.
 */
class Clutch
{
public:
  /// `buttons` is a mask. The clutch is held while any of its bits is set in DeviceSample::buttons.
  /// With the mask 0 there is no clutch.
  explicit Clutch(std::uint32_t buttons = 0) noexcept
    : Buttons(buttons)
  {
  }

  /// Returns the position of the tip. `hand` is the finite position to which the mapping maps the
  /// hand, mm. `elapsed` is the time since the last tick, s.
  Eigen::Vector3d follow(
    const Eigen::Vector3d& hand, std::uint32_t buttons, double elapsed) noexcept
  {
    if (this->Held) // also in the tick of the release, because the hand may have moved since the
                    // last tick
    {
      this->Offset = this->Tip - hand;
      this->Moved = true;
    }
    else
    {
      this->Tip = this->Moved ? Eigen::Vector3d(hand + this->Offset) : hand;
    }
    this->Held = (buttons & this->Buttons) != 0;
    this->Force.advance(this->Held ? 0.0 : 1.0, elapsed);
    return this->Tip;
  }

  bool isHeld() const noexcept { return this->Held; }
  /// Fraction of the force that acts on the hand. It is 1 while the tip follows the hand and 0
  /// while the hand moves freely.
  double forceShare() const noexcept { return this->Force.share(); }

  /// Removes the offset, so that the tip is at the mapped position of the hand again.
  void reset() noexcept { *this = Clutch(this->Buttons); }

private:
  std::uint32_t Buttons;
  bool Held = false;
  bool Moved = false; ///< whether Offset is used; adding a zero offset would change -0 to +0
  Eigen::Vector3d Tip = Eigen::Vector3d::Zero();
  /// Position of the tip minus mapped position of the hand, mm.
  Eigen::Vector3d Offset = Eigen::Vector3d::Zero();
  ForceRamp Force{ 1.0 };
};

/**
 * The part of a servo step that belongs to one device: mapping, clutch and safety chain. In a tick,
 * read() receives the sample, follow() returns the pose of the tool, feel() receives the force of
 * the scene at that pose, and send() computes the force for the device and stores it in the tick.
 * Between follow() and feel() the caller updates the contact. Without a valid sample there is no
 * tip, and follow() and feel() must not be called.
 *
 * All functions are for one thread and neither allocate, lock nor throw.
 */
class PALPATE_EXPORT DeviceEnd
{
public:
  /// The parameters are those of ServoStep.
  DeviceEnd(const WorkspaceMapping& mapping, const SafetySettings& safety,
    std::uint32_t clutchButtons) noexcept;

  /// Begins a tick. After the call, tick.valid is true if there is a tip.
  void read(const DeviceSample& sample, double time, Tick& tick, SafetyInput& input) noexcept;
  /// Returns the pose of the tool. `elapsed` is the time since the last tick, s.
  ToolPose follow(double elapsed, Tick& tick) noexcept;
  /// Receives the force of the scene at the pose that follow() returned.
  void feel(const SceneForce& felt, Tick& tick, SafetyInput& input) noexcept;
  /// Ends a tick. Returns true if the force was ended, not only changed; the caller must then end
  /// the contact.
  bool send(const SafetyInput& input, Tick& tick) noexcept;

  /// Whether no force is sent at `time` even if the sample is valid, regardless of the scene
  /// (SafetyChain::isEnded).
  bool isEnded(double time) const noexcept { return this->Chain.isEnded(time); }

  void stop() noexcept { this->Chain.stop(); }
  void start() noexcept { this->Chain.start(); }
  void reset() noexcept;

  const WorkspaceMapping& mapping() const noexcept { return this->Mapping; }
  const SafetySettings& safety() const noexcept { return this->Safety; }
  /// The largest stiffnesses that a scene with the force factor 1 may have at this device.
  const StiffnessLimits& limits() const noexcept { return this->Limits; }
  double energy() const noexcept { return this->Chain.energy(); }
  double spareEnergy() const noexcept { return this->Chain.spareEnergy(); }
  void transferEnergy(double energy) noexcept { this->Chain.transferEnergy(energy); }

private:
  WorkspaceMapping Mapping;
  SafetyChain Chain;
  SafetySettings Safety;
  Clutch Hand;
  StiffnessLimits Limits;
  bool IsSound;      ///< whether the mapping is without a fault
  double Held = 1.0; ///< fraction of the force in the last tick
};
} // namespace palpate

#endif
