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
  bool outside = false;                                 ///< the tip is not in contact
  Eigen::Vector3d idealForce = Eigen::Vector3d::Zero(); ///< the scene's force, N
  /// The scene's force with the stiffness cap applied (CappedResponse up to bodyStiffnessLimit);
  /// equal to idealForce if nothing is capped.
  Eigen::Vector3d cappedForce = Eigen::Vector3d::Zero();
  /// m: the longest displacement over which the present force can return the energy that the hand
  /// has put in: the deflection and, with friction, the largest pre-sliding displacement. Infinite
  /// if unknown.
  double depth = std::numeric_limits<double>::infinity();
  ToolOrientation orientation = orientationNotTold(); ///< as in DeviceSample
  /// Torques about the tip, N m: the scene's torque, and this torque with the stiffness cap
  /// applied.
  Eigen::Vector3d idealTorque = Eigen::Vector3d::Zero();
  Eigen::Vector3d cappedTorque = Eigen::Vector3d::Zero();
  /// The force changes intentionally, not by the hand: a body, tool or material is being exchanged.
  bool changing = false;
};

/// The links of the chain; a tick reports the links that changed the force.
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

/// The sent force, and the links that changed it.
struct SafeForce
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< N
  Eigen::Vector3d torque = Eigen::Vector3d::Zero(); ///< N m, about the tip
  double forceFactor = 1.0;
  std::uint16_t acted = 0; ///< sum of SafetyLink
  /// s: after this time without a further force the device must end the force itself.
  double holdTime = 0.0;
  bool isGap = false; ///< there is no force now, but the contact continues with the next reading

  bool has(SafetyLink link) const noexcept
  {
    return (this->acted & static_cast<std::uint16_t>(link)) != 0;
  }
};

/**
 * Computes the force sent to a device from the ideal force on a tool, in this fixed order:
 *
 * finite check → gate (EntryGate) → fit to device (one force factor) → stiffness cap → slew limit
 * (ForceRateLimit) → magnitude clamp (ForceLimit) → passivity control (PassivityControl) → watchdog
 * (SampleWatchdog) → no force while the chain is stopped or there is no sample.
 *
 * The finite check, the watchdog and the last link end the force in the same tick. This counts as a
 * loss: the gate closes, and slew limit and passivity control are reset. A clock that decreases is
 * also a loss; the clock is not checked if no active link needs the time.
 *
 * Each force has a hold time. While the force is held for this time, it returns no more energy than
 * the hand has put in, according to the passivity control. The hold time is at least LeastHold
 * periods, by which a loop may be late, and at most the sample time-out. If the host hangs, a
 * device that ends its force after the hold time is safe.
 *
 * Under passivity control, readings that are missing for no longer than the device's time-out are a
 * gap, not a loss. There is no force during the gap, but the gate is unchanged, the slew limit
 * continues from zero, and the control continues to count. Therefore a hand that moves deeper
 * during the gap receives no more energy than it had put in before.
 *
 * If a device outputs torque (SafetySettings::maximumTorque above 0), the torque passes the same
 * links: the same gate and factor, and a separate stiffness cap, slew limit and clamp. Passivity
 * control has one account for force and torque. The torque is zero in every tick in which the force
 * is ended, and if the device's orientation is unknown. Without torque output no torque is sent,
 * and the force is bit for bit the same.
 *
 * All members are for the servo thread; none allocates, locks or throws.
 */
class PALPATE_EXPORT SafetyChain
{
public:
  explicit SafetyChain(const SafetySettings& settings) noexcept;

  static constexpr double LeastHold = 5.0; ///< periods

  SafeForce apply(const SafetyInput& input) noexcept;
  /// Ends the force from the next tick until start().
  void stop() noexcept;
  void start() noexcept { this->IsStopped = false; }
  bool isStopped() const noexcept { return this->IsStopped; }
  /// Whether apply() will send no force for a valid sample at that time, for any scene: the
  /// chain is stopped, the watchdog has expired, or the time is invalid.
  bool isEnded(double time) const noexcept
  {
    return this->IsStopped ||
      (this->UsesTime && (!std::isfinite(time) || this->Watchdog.wouldBeLost(time)));
  }
  /// Resets the links; a stopped chain remains stopped.
  void reset() noexcept;

  /// Sets the force factor, 0 to 1; a larger one counts as 1, a negative one or NaN as 0. It
  /// applies immediately: the caller must change it gradually, and mark the ticks as changing if it
  /// grows.
  void setForceFactor(double factor) noexcept;
  const SafetySettings& settings() const noexcept { return this->Settings; }
  /// The largest stiffness (N/mm, frame of the body) that the device renders at this scale of the
  /// mapping (WorkspaceMapping) and the present force factor; infinite without cap.
  double bodyStiffnessLimit(double scale) const noexcept;
  /// The torsional stiffness limit, N mm/rad, in the same way.
  double bodyTorsionalLimit(double scale) const noexcept;
  /// Whether torque is sent at all.
  bool hasTorque() const noexcept { return this->Settings.maximumTorque > 0.0; }
  /// The energy that the hand has put in and not received back, J (PassivityControl); 0 if
  /// passivity control is off.
  double energy() const noexcept { return this->Passivity.energy(); }
  /// The part of this energy that may be transferred to another chain on the same body, and the
  /// transfer (PassivityControl).
  double spareEnergy() const noexcept
  {
    return this->Settings.controlPassivity ? this->Passivity.spare() : 0.0;
  }
  void transferEnergy(double energy) noexcept { this->Passivity.transfer(energy); }

private:
  /// The links that end the force in this tick.
  std::uint16_t losses(const SafetyInput& input) noexcept;
  Wrench shape(const SafetyInput& input, SafeForce& result) noexcept;
  /// The scene's torque after the clamp; `share` is the factor of gate and fit.
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
