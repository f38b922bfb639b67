// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_TickChecker_h
#define palpate_endurance_TickChecker_h

#include "LossRule.h"
#include "OutsideRule.h"
#include "SceneRule.h"
#include "TickFacts.h"
#include "VisitLedger.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace palpate::endurance
{
/// The stated limits of the device, in SI units.
struct DeviceLimits
{
  double force = 3.0;        ///< N
  double stiffness = 1500.0; ///< N/m
  double forceRate = 40.0;   ///< N/s
  double timeOut = 0.0201;   ///< s; not a whole number of ticks
};
/// Returns the specification with these limits, at a rate in Hz.
DeviceSpecification specificationOf(const DeviceLimits& limits, double rate);

/// Faults of a tick.
enum class TickFault : std::uint8_t
{
  None,
  NotFinite, ///< a force that is not a finite number
  Time,      ///< time does not increase
  Record,    ///< sent and recorded force differ
  Tip,       ///< the tip is not at the position that the device reported
  Scene,     ///< a scene that was not offered, a skipped scene, or a wrong share
  /// Force does not match body and position: outdated, of a wrong body, or outside the cone.
  Contact,
  /// A force without a sample, after a failure, or before the tip has been outside again.
  AfterLoss,
  Sent,  ///< the sent force is not the limited contact force
  Energy ///< a visit to a relaxing body returned more energy than the tip had put in
};
const char* nameOf(TickFault fault);

struct TickVerdict
{
  TickFault fault = TickFault::None;
  std::string text;
  explicit operator bool() const { return this->fault != TickFault::None; }
};

/// Counts over all ticks checked.
struct TickTally
{
  std::uint64_t ticks = 0;
  std::uint64_t faults = 0;
  std::uint64_t lost = 0;   ///< ticks without force, because a sample is missing
  std::uint64_t silent = 0; ///< part of `lost`: there was a sample, but no new one for too long
  std::uint64_t shut = 0;   ///< ticks inside the body, without force until the tip has been outside
  std::uint64_t free = 0;   ///< ticks outside
  std::uint64_t felt = 0;   ///< ticks with a force
  std::uint64_t changing = 0; ///< part of `felt`: two scenes share the force
  std::uint64_t limited =
    0; ///< part of `felt`: the passivity control acts, so only an upper bound is checked
  std::uint64_t staleSeen =
    0; ///< part of `felt`: the force of the previous tick would have been rejected
  std::uint64_t relaxing =
    0; ///< ticks whose force is at least partly from a relaxing body; not in `felt`
  std::uint64_t visits = 0;   ///< visits to a relaxing body whose energy was checked
  double largestGain = -1.0;  ///< largest energy gained in a visit, divided by force times path
  double largestForce = 0.0;  ///< N
  double largestStep = 0.0;   ///< largest difference between two ticks with a force, N
  double largestExcess = 0.0; ///< largest difference beyond the tolerance, N
  double nearest = 0.0;       ///< largest ratio of the difference from the model to its tolerance
};

/**
 * Computes the allowed force on the hand independently, tick by tick, from the samples of the
 * device: the position from the frame, the depth by a search over all triangles, the force by a
 * closed form. Then it applies the cap, the friction cone, the ramp between bodies, the slew limit
 * and the force limit; after a loss there is no force. The rules are stated in
 * Interactors/Haptics/README.md. The code there is not used.
 * Two values are taken from the tick. One is the amount of friction, which depends on the path and
 * not only on the position. The friction must be in the cone and in the tangent plane. The other is
 * whether the passivity control acted. If it did, the force must have the direction of the model's
 * force and at most its magnitude. All other checks have a lower and an upper bound, so that a
 * force of the previous sample is detected.
 * The force of a relaxing body depends on its whole history, so only bounds are checked. The normal
 * part is between zero and the instantaneous force; the tangential part is within the cone and the
 * drag. The sent force is at most as large as this bound and rises at most at the allowed rate. In
 * addition, a visit, from outside to outside, must not gain energy (VisitLedger).
 */
class TickChecker
{
public:
  TickChecker(const DeviceFrame& frame, const DeviceLimits& limits, FeltScene first);

  /// Adds a scene that may be in contact from now on. Scenes are numbered in the order of these
  /// calls, starting with 1.
  void offer(FeltScene next) { this->Scenes.offer(std::move(next)); }
  const SceneRule& scenes() const { return this->Scenes; }

  TickVerdict check(const TickFacts& tick);
  const TickTally& tally() const { return this->Tally; }

private:
  /// The model's force and its tolerance, N.
  struct Expected
  {
    Vector3 force = Vector3::Zero();
    double tolerance = 0.0;
    bool isInside = false;  ///< certainly inside a body
    bool isOutside = false; ///< certainly outside all bodies
    bool isBound = false;   ///< the body relaxes: the force is an upper bound
  };
  /// How well a force fits one scene at the tip. If several points are equally near, the best fit
  /// is used.
  struct Fit
  {
    double excess = 0.0; ///< difference beyond the tolerance, N; a negative value is the margin
    double cap = 1.0;    ///< fraction of the force that remains after the stiffness cap
    double tolerance = 0.0;
    double error = 0.0;
    double depth = 0.0;
  };
  /// `step`: distance that the tip has moved since the previous tick, mm.
  Fit fit(const FeltScene& scene, const Vector3& tip, double step, const Vector3& force,
    double share) const;

  TickVerdict checkPlace(const TickFacts& tick, double elapsed, Expected& expected);
  TickVerdict checkSent(const TickFacts& tick, const Expected& expected);
  TickVerdict checkNothing(const TickFacts& tick, const char* reason);
  TickVerdict compare(const TickFacts& tick, const Vector3& allowed, double tolerance);
  TickVerdict checkBound(const TickFacts& tick, const Expected& expected);
  TickVerdict checkVisit(const TickFacts& tick, bool isOutside);
  Vector3 limited(const Vector3& wanted, double time) const;
  void lose();

  DeviceFrame Frame;
  DeviceLimits Limits;
  SceneRule Scenes;
  LossRule Loss;
  OutsideRule Gate;
  VisitLedger Visit;
  TickTally Tally;

  bool HasTime = false;
  double Time = 0.0;
  /// Position of the tip in the last tick with a position, mm; infinitely far away before the
  /// first.
  Vector3 LastTip = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 Sent = Vector3::Zero(); ///< force sent in the previous tick; zero after a loss
  bool HasSent = false;
  double SentTime = 0.0;
};
} // namespace palpate::endurance

#endif
