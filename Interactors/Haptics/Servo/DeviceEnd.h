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
  /// The force and torque that are sent.
  Wrench wrench() const noexcept { return { this->deviceForce, this->deviceTorque }; }
};

/**
 * Takes the hand off the tip, so that a small workspace reaches a large body: while one of its
 * buttons is held the tip stays and the hand moves freely; on release the tip follows again from
 * where it stood, moved by as much as the hand was.
 *
 * The force fades to nothing within 50 ms of pressing the button and comes back within 50 ms of
 * its release (ForceRamp), in or out of contact: neither tip nor force jumps. A gate that is shut
 * stays shut, as the tip has not left the body by it.
 *
 * Positions are the tip's, in the body's frame, mm. No heap; nothing throws.
 */
class Clutch
{
public:
  /// `buttons`: any of these bits of DeviceSample::buttons holds it; 0: there is no clutch.
  explicit Clutch(std::uint32_t buttons = 0) noexcept
    : Buttons(buttons)
  {
  }

  /// Where the tip is, when the mapping puts the hand at `hand`, finite; `elapsed` (s) since the
  /// last tick.
  Eigen::Vector3d follow(
    const Eigen::Vector3d& hand, std::uint32_t buttons, double elapsed) noexcept
  {
    if (this->Held) // up to this tick, however far the hand has come since the last
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
  /// The share of the force that the hand gets: 1 while the tip follows it, 0 while it moves
  /// freely.
  double forceShare() const noexcept { return this->Force.share(); }

  /// The tip is where the mapping puts it, as at the beginning.
  void reset() noexcept { *this = Clutch(this->Buttons); }

private:
  std::uint32_t Buttons;
  bool Held = false;
  bool Moved = false; ///< Offset is not zero: adding zero would turn -0 into +0
  Eigen::Vector3d Tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d Offset = Eigen::Vector3d::Zero(); ///< tip minus hand
  ForceRamp Force{ 1.0 };
};

/**
 * What of a servo step belongs to one device: mapping, clutch and safety chain. A tick reads the
 * sample, follows the tip, takes what that feels, and sends; in between the caller steps the
 * contact. Without a valid sample there is no tip to be followed or felt.
 *
 * Nothing here allocates, locks or throws; for one thread.
 */
class PALPATE_EXPORT DeviceEnd
{
public:
  /// Parameters as of ServoStep.
  DeviceEnd(const WorkspaceMapping& mapping, const SafetySettings& safety,
    std::uint32_t clutchButtons) noexcept;

  /// Begins a tick; tick.valid says whether there is a tip.
  void read(const DeviceSample& sample, double time, Tick& tick, SafetyInput& input) noexcept;
  /// Where the tool is, `elapsed` s after the last tick.
  ToolPose follow(double elapsed, Tick& tick) noexcept;
  /// What it feels there.
  void feel(const SceneForce& felt, Tick& tick, SafetyInput& input) noexcept;
  /// Ends a tick. True: the force was ended, not changed; the contact is to be forgotten.
  bool send(const SafetyInput& input, Tick& tick) noexcept;

  /// Whether a sample at that time has no force, whatever is felt (SafetyChain::isEnded).
  bool isEnded(double time) const noexcept { return this->Chain.isEnded(time); }

  void stop() noexcept { this->Chain.stop(); }
  void start() noexcept { this->Chain.start(); }
  void reset() noexcept;

  const WorkspaceMapping& mapping() const noexcept { return this->Mapping; }
  const SafetySettings& safety() const noexcept { return this->Safety; }
  /// Up to which stiffness a scene of force factor 1 may be felt.
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
  bool IsSound;      ///< the mapping
  double Held = 1.0; ///< share of the force that the hand got in the tick before
};
} // namespace palpate

#endif
