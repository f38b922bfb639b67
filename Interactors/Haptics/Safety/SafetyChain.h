// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SafetyChain_h
#define palpate_SafetyChain_h

#include "Mechanics/PalpateExport.h"
#include "Haptics/Safety/PassivityControl.h"
#include "Haptics/Safety/SafetyLinks.h"
#include "Haptics/Safety/SafetySettings.h"

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <limits>

namespace palpate
{
/// The input of SafetyChain in one tick. Device frame, SI units.
struct SafetyInput
{
  double time = 0.0; ///< s
  bool valid = false;
  bool fresh = true;                                    ///< as in DeviceSample
  Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< m
  bool outside = false;                                 ///< whether the tip is not in contact
  Eigen::Vector3d idealForce = Eigen::Vector3d::Zero(); ///< the scene's force, N
  /// The scene's force after the stiffness cap (CappedResponse up to bodyStiffnessLimit). It equals
  /// idealForce if nothing is capped.
  Eigen::Vector3d cappedForce = Eigen::Vector3d::Zero();
  /// Longest displacement, m, over which the present force can return the energy that the hand has
  /// put in. It is the deflection plus, with friction, the largest pre-sliding displacement.
  /// Infinite if unknown.
  double depth = std::numeric_limits<double>::infinity();
  ToolOrientation orientation = orientationNotTold(); ///< as in DeviceSample
  /// Torques about the tip, N m: the scene's torque without and with the stiffness cap.
  Eigen::Vector3d idealTorque = Eigen::Vector3d::Zero();
  Eigen::Vector3d cappedTorque = Eigen::Vector3d::Zero();
  /// Whether the force changes because a body, tool or material is being exchanged, not because the
  /// hand moves.
  bool changing = false;
};

/// The links of the chain. A tick reports which links changed the force.
enum class SafetyLink : std::uint16_t
{
  NotFinite = 1 << 0, ///< a force or a time that is not finite
  Gate = 1 << 1,
  Fit = 1 << 2,
  StiffnessCap = 1 << 3,
  Slew = 1 << 4,
  Magnitude = 1 << 5,
  Passivity = 1 << 6,
  Watchdog = 1 << 7,
  NoSample = 1 << 8, ///< the sample is not valid or not finite
  Stopped = 1 << 9
};

/// The force and torque that are sent, and the links that changed them.
struct SafeForce
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< N
  Eigen::Vector3d torque = Eigen::Vector3d::Zero(); ///< N m, about the tip
  double forceFactor = 1.0;
  std::uint16_t acted = 0; ///< sum of SafetyLink
  /// Time, s, after which the device must end the force by itself if no further force follows.
  double holdTime = 0.0;
  /// Whether the force is zero now but the contact continues with the next reading.
  bool isGap = false;

  bool has(SafetyLink link) const noexcept
  {
    return (this->acted & static_cast<std::uint16_t>(link)) != 0;
  }
};

/**
 * Computes the force that is sent to a device from the ideal force on a tool. The links act in this
 * fixed order:
 *
 * finite check → gate (EntryGate) → fit to device (one force factor) → stiffness cap → slew limit
 * (ForceRateLimit) → magnitude clamp (ForceLimit) → passivity control (PassivityControl) → watchdog
 * (SampleWatchdog) → no force while the chain is stopped or there is no sample.
 *
 * The finite check, the watchdog and the last link end the force in the same tick. An end by one of
 * these links is a loss: the gate closes, and slew limit and passivity control are reset. A clock
 * that decreases is also a loss. The clock is not checked if no active link needs the time.
 *
 * Each force has a hold time. According to the passivity control, a force that is held for this
 * time returns no more energy than the hand has put in. The hold time is at least LeastHold
 * periods, because a loop may be late, and at most the sample time-out. If the host hangs, a device
 * that ends its force after the hold time is safe.
 *
 * Under passivity control, readings that are missing for no longer than the device's time-out are a
 * gap, not a loss. During a gap the force is zero, the gate is unchanged, the slew limit continues
 * from zero, and the passivity control continues to count. Therefore a hand that moves deeper
 * during the gap receives no more energy than it had put in before.
 *
 * If a device outputs torque (SafetySettings::maximumTorque above 0), the torque passes the same
 * links. Gate and factor are the same as for the force; stiffness cap, slew limit and clamp are
 * separate. Passivity control has one account for force and torque. The torque is zero in every
 * tick in which the force is ended, and if the device's orientation is unknown. Without torque
 * output no torque is sent, and the force is bit for bit the same.
 *
 * All member functions are for the servo thread and neither allocate, lock nor throw.
 */
class PALPATE_EXPORT SafetyChain
{
public:
  explicit SafetyChain(const SafetySettings& settings) noexcept;

  static constexpr double LeastHold = 5.0; ///< least hold time, periods

  SafeForce apply(const SafetyInput& input) noexcept;
  /// Ends the force from the next tick until start().
  void stop() noexcept;
  void start() noexcept { this->IsStopped = false; }
  bool isStopped() const noexcept { return this->IsStopped; }
  /// Whether apply() sends no force at `time` even if the sample is valid, regardless of the scene.
  /// This is so if the chain is stopped, the watchdog has expired, or the time is invalid.
  bool isEnded(double time) const noexcept
  {
    return this->IsStopped ||
      (this->UsesTime && (!std::isfinite(time) || this->Watchdog.wouldBeLost(time)));
  }
  /// Resets the links; a stopped chain remains stopped.
  void reset() noexcept;

  /// Sets the force factor. Its range is 0 to 1; a larger factor counts as 1, a negative factor or
  /// NaN as 0. The factor applies immediately. Therefore the caller must change it gradually, and
  /// must set SafetyInput::changing in the ticks in which it grows.
  void setForceFactor(double factor) noexcept;
  const SafetySettings& settings() const noexcept { return this->Settings; }
  /// The largest stiffness (N/mm, body frame) that the device renders at the present force factor
  /// and the scale `scale` of the mapping (WorkspaceMapping). Infinite if the stiffness is not
  /// capped.
  double bodyStiffnessLimit(double scale) const noexcept;
  /// The largest torsional stiffness, N mm/rad, defined as bodyStiffnessLimit.
  double bodyTorsionalLimit(double scale) const noexcept;
  /// Whether torques are sent.
  bool hasTorque() const noexcept { return this->Settings.maximumTorque > 0.0; }
  /// The energy that the hand has put in and not received back, J (PassivityControl). 0 if
  /// passivity control is off.
  double energy() const noexcept { return this->Passivity.energy(); }
  /// The part of energy() that may be transferred to another chain on the same body, and the
  /// function that transfers energy (PassivityControl).
  double spareEnergy() const noexcept
  {
    return this->Settings.controlPassivity ? this->Passivity.spare() : 0.0;
  }
  void transferEnergy(double energy) noexcept { this->Passivity.transfer(energy); }

private:
  /// The links that end the force in this tick, as a sum of SafetyLink.
  std::uint16_t losses(const SafetyInput& input) noexcept;
  Wrench shape(const SafetyInput& input, SafeForce& result) noexcept;
  /// Returns the scene's torque after the links up to the clamp. `share` is the product of the
  /// factors of gate and fit.
  Eigen::Vector3d shapeTorque(
    const SafetyInput& input, double share, Eigen::Vector3d& wanted, SafeForce& result) noexcept;
  Wrench controlPassivity(
    const SafetyInput& input, bool changing, const Wrench& wanted, const Wrench& limited) noexcept;
  void restart() noexcept;
  void interrupt(double time) noexcept;
  double holdTime() const noexcept;

  SafetySettings Settings;
  bool UsesTime;
  EntryGate Gate;
  ForceRateLimit Slew;
  ForceLimit Magnitude;
  ForceRateLimit TorqueSlew;
  ForceLimit TorqueMagnitude;
  SampleWatchdog Watchdog;
  double LastGateShare = 1.0;
  bool IsStopped = false;
  PassivityControl Passivity; ///< last member, because it is the largest
};
} // namespace palpate

#endif
