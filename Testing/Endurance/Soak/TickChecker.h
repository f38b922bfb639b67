// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_TickChecker_h
#define palpate_endurance_TickChecker_h

#include "LossRule.h"
#include "OutsideRule.h"
#include "SceneRule.h"
#include "TickFacts.h"
#include "VisitLedger.h"

#include <cstdint>
#include <string>
#include <vector>

namespace palpate::endurance
{
/// What the device is said to be good for. SI.
struct DeviceLimits
{
  double force = 3.0;        ///< N
  double stiffness = 1500.0; ///< N/m
  double forceRate = 40.0;   ///< N/s
  double timeOut = 0.0201;   ///< s; no whole number of ticks
};
/// As the device states them, at a rate (Hz).
DeviceSpecification specificationOf(const DeviceLimits& limits, double rate);

/// What is wrong with a tick.
enum class TickFault : std::uint8_t
{
  None,
  NotFinite, ///< a force that is no number
  Time,      ///< that does not go on
  Record,    ///< what was sent is not what was recorded
  Tip,       ///< not where the device says
  Scene,     ///< one that was never offered, passed over, or felt with a wrong share
  Contact,   ///< not the force of this body at this place: stale, wrong body, not in the cone
  AfterLoss, ///< a force without a sample, after a failure, or before the tip was outside again
  Sent,      ///< not what the limits make of the contact force
  Energy     ///< a visit to a body that relaxes gave more than was put in
};
const char* nameOf(TickFault fault);

struct TickVerdict
{
  TickFault fault = TickFault::None;
  std::string text;
  explicit operator bool() const { return this->fault != TickFault::None; }
};

/// What was seen in all ticks checked.
struct TickTally
{
  std::uint64_t ticks = 0;
  std::uint64_t faults = 0;
  std::uint64_t lost = 0;      ///< no force, for want of a sample
  std::uint64_t silent = 0;    ///< of these: there was one, but nothing new for too long
  std::uint64_t shut = 0;      ///< in the body, but no force before the tip was outside
  std::uint64_t free = 0;      ///< outside
  std::uint64_t felt = 0;      ///< with a force
  std::uint64_t changing = 0;  ///< of these: of two scenes
  std::uint64_t limited = 0;   ///< of these: an upper bound only, the passivity control at work
  std::uint64_t staleSeen = 0; ///< of these: the force of the tick before would have been refused
  std::uint64_t relaxing =
    0;                       ///< with a force, in part or whole of a body that relaxes; not in felt
  std::uint64_t visits = 0;  ///< to such a body, whose energy was judged
  double largestGain = -1.0; ///< of these, got out over force times way
  double largestForce = 0.0; ///< N
  double largestStep = 0.0;  ///< N, between two ticks with a force
  double largestExcess = 0.0; ///< N, beyond what is allowed
  double nearest = 0.0;       ///< the largest difference from the model over its tolerance
};

/**
 * What the force on the hand may be, tick by tick, computed once more from what the device said:
 * place by the frame, depth by brute force, force by closed form, capped, within the friction cone,
 * ramped from body to body, slewed, limited; none after a loss. The rules are those of
 * Interactors/Haptics/README.md; nothing of the code there is called.
 *
 * Two things are taken from the tick: how much friction there is, which depends on the way and not
 * on the place (it must lie in the cone and in the tangent plane), and whether the passivity
 * control acted (then the force must have the direction and at most the size of the model's). All
 * else is two-sided, so that a force which was right for the sample before is found out.
 *
 * Of a body that relaxes the force hangs on all that was done to it, and only bounds are told:
 * along the normal from nothing to the instantaneous force, across it within the cone and the drag;
 * what is sent no more than that, and rising no faster than allowed. But over a visit, from outside
 * to outside, no energy may have been got out (VisitLedger).
 */
class TickChecker
{
public:
  TickChecker(const DeviceFrame& frame, const DeviceLimits& limits, FeltScene first);

  /// Another scene that may be felt from now on; how many were offered is its number.
  void offer(FeltScene next) { this->Scenes.offer(std::move(next)); }
  const SceneRule& scenes() const { return this->Scenes; }

  TickVerdict check(const TickFacts& tick);
  const TickTally& tally() const { return this->Tally; }

private:
  /// The model's force, and how far from it counts as equal. N.
  struct Expected
  {
    Vector3 force = Vector3::Zero();
    double tolerance = 0.0;
    bool isInside = false;  ///< of a body, for certain
    bool isOutside = false; ///< of all
    bool isBound = false;   ///< of a body that relaxes: the force is the most that it may be
  };
  /// How well a force fits one scene at the tip, or the best of several places as near.
  struct Fit
  {
    double excess = 0.0; ///< N, beyond what is allowed; negative: so much is left
    double cap = 1.0;    ///< what the stiffness cap leaves of it
    double tolerance = 0.0;
    double error = 0.0;
    double depth = 0.0;
  };
  Fit fit(const FeltScene& scene, const Vector3& tip, const Vector3& force, double share) const;

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
  Vector3 Sent = Vector3::Zero(); ///< by the tick before; nothing after a loss
  bool HasSent = false;
  double SentTime = 0.0;
};
} // namespace palpate::endurance

#endif
