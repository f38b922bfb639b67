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
/// One tick of a servo loop, as SafetyChain needs it. Device frame, SI units.
struct SafetyInput
{
  double time = 0.0; ///< s
  bool valid = false;
  bool fresh = true;                                    ///< as in DeviceSample
  Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< m
  bool outside = false;                                 ///< the tip touches nothing now
  Eigen::Vector3d idealForce = Eigen::Vector3d::Zero(); ///< what the scene gives, N
  /// The same with the stiffness cap applied (CappedResponse up to bodyStiffnessLimit); the same
  /// force where there is nothing to cap.
  Eigen::Vector3d cappedForce = Eigen::Vector3d::Zero();
  /// m: over no longer way can the force of now give back what the hand has put in: the deflection
  /// and, with friction, how far its spring can be stretched. Infinite where it is not known.
  double depth = std::numeric_limits<double>::infinity();
  ToolOrientation orientation = orientationNotTold(); ///< as in DeviceSample
  /// About the tip, N m: what the scene gives, and the same with the stiffness cap applied.
  Eigen::Vector3d idealTorque = Eigen::Vector3d::Zero();
  Eigen::Vector3d cappedTorque = Eigen::Vector3d::Zero();
  /// The force is being changed on purpose, not by the hand: a body, tool or material is exchanged.
  bool changing = false;
};

/// A link that changed something in a tick.
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
  NoSample = 1 << 8, ///< the device has nothing to report, or no place
  Stopped = 1 << 9
};

/// What is sent, and why it is not the ideal force.
struct SafeForce
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< N
  Eigen::Vector3d torque = Eigen::Vector3d::Zero(); ///< N m, about the tip
  double forceFactor = 1.0;
  std::uint16_t acted = 0; ///< sum of SafetyLink
  /// s: the device is to let go by itself when nothing more has been sent for so long.
  double holdTime = 0.0;
  bool isGap = false; ///< no force, but what was touched goes on when readings do

  bool has(SafetyLink link) const noexcept
  {
    return (this->acted & static_cast<std::uint16_t>(link)) != 0;
  }
};

/**
 * From the force a tool should feel to the one that is sent to a device, in fixed order:
 *
 * finite check → gate (EntryGate) → fit to device (one force factor) → stiffness cap → slew limit
 * (ForceRateLimit) → magnitude clamp (ForceLimit) → passivity control (PassivityControl) → watchdog
 * (SampleWatchdog) → nothing at all while stopped or without a sample.
 *
 * What ends the force - the first and the last links - ends it in the very same tick, exactly, and
 * counts as a loss: the gate closes, and slew limit and passivity control begin anew. A clock that
 * goes back is a loss too; where no link that is on needs the time, it is not looked at.
 *
 * A force is told for a time: for so long as it can give back no more than the hand has put in, by
 * the passivity control, at least LeastHold periods, which a loop may be late, at most the sample
 * time-out. A device that lets go after it survives a host that hangs.
 *
 * Readings that are missing for no longer than the device's time-out are a gap instead, under
 * passivity control: there is no force without one, as ever, but the gate stays as it is, the slew
 * limit goes on from nothing, and the control counts on, so that a hand which meanwhile went deeper
 * gets no more than it had put in before.
 *
 * Of a device that outputs torque (SafetySettings::maximumTorque above 0) the torque goes the same
 * way: by the same gate and factor, with a stiffness cap, slew limit and clamp of its own, and in
 * one account with the force under passivity control; it is zero in every tick in which the force
 * is ended, and where the device does not tell how the tool is turned. Without, no torque is sent,
 * and the force is what it always was, to the bit.
 *
 * All members belong to the servo thread; none allocates, locks or throws.
 */
class PALPATE_EXPORT SafetyChain
{
public:
  explicit SafetyChain(const SafetySettings& settings) noexcept;

  static constexpr double LeastHold = 5.0; ///< periods

  SafeForce apply(const SafetyInput& input) noexcept;
  /// No force from the next tick on, until start().
  void stop() noexcept;
  void start() noexcept { this->IsStopped = false; }
  bool isStopped() const noexcept { return this->IsStopped; }
  /// Whether apply() will send nothing for a valid sample at that time, whatever the scene gives:
  /// it is stopped, the device has been silent, or the time is none.
  bool isEnded(double time) const noexcept
  {
    return this->IsStopped ||
      (this->UsesTime && (!std::isfinite(time) || this->Watchdog.wouldBeLost(time)));
  }
  /// Begins anew; what is stopped stays stopped.
  void reset() noexcept;

  /// 0 to 1; beyond that 1, and 0 for NaN. At once: to change it gradually is the
  /// caller's, in ticks marked as changing where it grows.
  void setForceFactor(double factor) noexcept;
  const SafetySettings& settings() const noexcept { return this->Settings; }
  /// Up to which stiffness (N/mm) in the frame of the body the device renders, at this scale of the
  /// mapping (WorkspaceMapping) and the force factor of now; infinite where nothing is capped.
  double bodyStiffnessLimit(double scale) const noexcept;
  /// Likewise N mm/rad, for torques.
  double bodyTorsionalLimit(double scale) const noexcept;
  /// Whether torque is sent at all.
  bool hasTorque() const noexcept { return this->Settings.maximumTorque > 0.0; }
  /// What the hand has put in and not got back, J (PassivityControl); 0 where that is off.
  double energy() const noexcept { return this->Passivity.energy(); }
  /// What of it may go to another chain on the same body, and what goes (PassivityControl).
  double spareEnergy() const noexcept
  {
    return this->Settings.controlPassivity ? this->Passivity.spare() : 0.0;
  }
  void transferEnergy(double energy) noexcept { this->Passivity.transfer(energy); }

private:
  /// Which links end the force now.
  std::uint16_t losses(const SafetyInput& input) noexcept;
  Wrench shape(const SafetyInput& input, SafeForce& result) noexcept;
  /// What of the scene's torque comes to the clamp's end; `share` is that of gate and fit.
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
  PassivityControl Passivity; ///< last, since the largest
};
} // namespace palpate

#endif
