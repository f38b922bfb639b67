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
/// The specification with these limits, at a rate in Hz.
DeviceSpecification specificationOf(const DeviceLimits& limits, double rate);

/// Faults of a tick.
enum class TickFault : std::uint8_t
{
  None,
  NotFinite, ///< a force that is not a finite number
  Time,      ///< time does not increase
  Record,    ///< sent and recorded force differ
  Tip,       ///< not at the position that the device reported
  Scene,     ///< a scene never offered, a skipped one, or a wrong share
  Contact,   ///< not the force of this body at this place: stale, wrong body, or outside the cone
  AfterLoss, ///< a force without a sample, after a failure, or before the tip was outside again
  Sent,      ///< not the contact force after the limits
  Energy     ///< a visit to a relaxing body returned more energy than was put in
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
  std::uint64_t lost = 0;     ///< no force, because a sample is missing
  std::uint64_t silent = 0;   ///< part of `lost`: there was a sample, but nothing new for too long
  std::uint64_t shut = 0;     ///< in the body, but no force until the tip has been outside
  std::uint64_t free = 0;     ///< outside
  std::uint64_t felt = 0;     ///< with a force
  std::uint64_t changing = 0; ///< part of `felt`: two scenes share the force
  std::uint64_t limited =
    0; ///< part of `felt`: the passivity control acts, only an upper bound is checked
  std::uint64_t staleSeen =
    0; ///< part of `felt`: the force of the tick before would have been rejected
  std::uint64_t relaxing =
    0; ///< with a force of which a part or all is from a relaxing body; not in `felt`
  std::uint64_t visits = 0;   ///< to such a body, with a check of the energy
  double largestGain = -1.0;  ///< largest energy gained in a visit, over force times path
  double largestForce = 0.0;  ///< N
  double largestStep = 0.0;   ///< N, between two ticks with a force
  double largestExcess = 0.0; ///< N, beyond the tolerance
  double nearest = 0.0;       ///< largest ratio of the difference from the model to its tolerance
};

/**
 * Computes the allowed force on the hand once more, tick by tick, from the samples of the device:
 * the position from the frame, the depth by brute force, the force by closed form. Then it applies
 * the cap, the friction cone, the ramp between bodies, the slew limit and the force limit; after a
 * loss there is no force. The rules are those of Interactors/Haptics/README.md. None of the code
 * there is called.
 * Two values are taken from the tick. One is the amount of friction, which depends on the path and
 * not on the position. It must be in the cone and in the tangent plane. The other is whether the
 * passivity control acted: then the force must have the direction of the model's force and at most
 * its magnitude. All other checks are two-sided, so that a force that belongs to the sample before
 * is detected.
 * The force of a body that relaxes depends on its whole history, so only bounds are checked. The
 * normal part is between zero and the instantaneous force, the tangential part within the cone and
 * the drag. The sent force is no larger than that and rises no faster than allowed. But over a
 * visit, from outside to outside, there must be no gain of energy (VisitLedger).
 */
class TickChecker
{
public:
  TickChecker(const DeviceFrame& frame, const DeviceLimits& limits, FeltScene first);

  /// Adds a scene that may be in contact from now on. Its number is the number of scenes offered so
  /// far.
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
    bool isInside = false;  ///< inside a body, for certain
    bool isOutside = false; ///< outside all bodies, for certain
    bool isBound = false;   ///< the body relaxes: the force is an upper bound
  };
  /// How well a force fits one scene at the tip. If several places are equally near, the best fit.
  struct Fit
  {
    double excess = 0.0; ///< N, beyond the tolerance; a negative value is the margin
    double cap = 1.0;    ///< the fraction that the stiffness cap leaves of the force
    double tolerance = 0.0;
    double error = 0.0;
    double depth = 0.0;
  };
  /// `step`: how far the tip has moved since the tick before, mm.
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
  /// Of the last tick with a position, mm; before the first it is infinitely far away.
  Vector3 LastTip = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 Sent = Vector3::Zero(); ///< by the tick before; zero after a loss
  bool HasSent = false;
  double SentTime = 0.0;
};
} // namespace palpate::endurance

#endif
