// SPDX-License-Identifier: BSD-3-Clause
#include "TickChecker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace palpate::endurance
{
namespace
{
constexpr double MillimetresPerMetre = 1000.0;
/// N; rounding error of doubles for forces of some N.
constexpr double Rounding = 1e-11;
/// Rounding error of a sum of two hundred steps, each computed from times of up to 1e5 s.
constexpr double ShareRounding = 1e-6;
/// mm; for tips about 100 mm from the device's origin.
constexpr double TipRounding = 1e-10;
/// Relative error of the direction of a force. Normals are stored as float32 (1e-7). The position
/// error is up to 1e-5 mm on facets of some mm, and normal and modulus change by a fifth between
/// the corners of a facet.
constexpr double DirectionError = 2e-6;
/// Relative to the instantaneous force at ChordDepth. The elements use chords instead of curves,
/// and after a press their force still depends on its largest depth for a while.
constexpr double ChordError = 0.01;
constexpr double ChordDepth = 2.0; // mm

/// Largest distance that the contact moves over the surface, mm, while the tip moves by `step` at
/// this depth. The body is round (R = 50 mm), and at an edge of 0.2 rad the nearest point jumps.
double contactWay(double step, double depth)
{
  return 1.2 * step + 0.2 * depth;
}

template <class... Parts>
TickVerdict fault(TickFault kind, const TickFacts& tick, const Parts&... parts)
{
  std::ostringstream text;
  text.precision(12);
  text << nameOf(kind) << " at " << tick.time << " s, scene " << tick.scene << ": ";
  (text << ... << parts);
  return { kind, text.str() };
}
} // namespace

const char* nameOf(TickFault fault)
{
  switch (fault)
  {
    case TickFault::None:
      return "nothing";
    case TickFault::NotFinite:
      return "not finite";
    case TickFault::Time:
      return "time";
    case TickFault::Record:
      return "record";
    case TickFault::Tip:
      return "tip";
    case TickFault::Scene:
      return "scene";
    case TickFault::Contact:
      return "contact force";
    case TickFault::AfterLoss:
      return "force after a loss";
    case TickFault::Energy:
      return "energy";
    default:
      return "force sent";
  }
}

DeviceSpecification specificationOf(const DeviceLimits& limits, double rate)
{
  DeviceSpecification specification;
  specification.maximumForce = limits.force;
  specification.maximumStiffness = limits.stiffness;
  specification.maximumForceRate = limits.forceRate;
  specification.sampleTimeOut = limits.timeOut;
  specification.rate = rate;
  return specification;
}

TickChecker::TickChecker(const DeviceFrame& frame, const DeviceLimits& limits, FeltScene first)
  : Frame(frame)
  , Limits(limits)
  , Scenes(std::move(first))
  , Loss(limits.timeOut)
{
}

TickVerdict TickChecker::check(const TickFacts& tick)
{
  ++this->Tally.ticks;
  TickVerdict verdict;
  if (this->HasTime && !(tick.time > this->Time))
  {
    verdict = fault(TickFault::Time, tick, "the tick before was at ", this->Time);
  }
  const double elapsed = this->HasTime ? tick.time - this->Time : 0.0;
  this->HasTime = true;
  this->Time = tick.time;

  const auto first = [&verdict](TickVerdict found)
  {
    if (!verdict)
    {
      verdict = std::move(found);
    }
  };
  if (!this->Scenes.enter(tick.scene))
  {
    first(fault(TickFault::Scene, tick, "after scene ", this->Scenes.current(), " of ",
      this->Scenes.offered()));
  }
  if (tick.sent != tick.saidSent)
  {
    first(fault(TickFault::Record, tick, "sent ", tick.sent.transpose(), " N, recorded ",
      tick.saidSent.transpose()));
  }
  Expected expected;
  if (LossRule::isPlaced(tick.sample))
  {
    first(this->checkPlace(tick, elapsed, expected));
  }
  if (this->Loss.isLost(tick.sample, tick.time))
  {
    ++this->Tally.lost;
    this->Tally.silent += LossRule::isPlaced(tick.sample) ? 1 : 0;
    first(this->checkNothing(tick, "there is no sample, or none that is new"));
    if (this->Loss.isGap(tick.sample, tick.time))
    {
      this->Sent.setZero();
      this->SentTime = tick.time;
    }
    else
    {
      this->lose();
    }
  }
  else
  {
    first(this->checkSent(tick, expected));
  }
  this->Tally.faults += verdict ? 1 : 0;
  return verdict;
}

void TickChecker::lose()
{
  this->Scenes.lose();
  this->Gate.lose();
  this->Visit.lose();
  this->HasSent = false;
  this->Sent.setZero();
}

TickChecker::Fit TickChecker::fit(
  const FeltScene& scene, const Vector3& tip, double step, const Vector3& force, double share) const
{
  const double most = this->Limits.stiffness / (MillimetresPerMetre * this->Frame.scale);
  Fit best;
  best.excess = std::numeric_limits<double>::infinity();
  for (const RoundBody::Touch& touch : scene.body->touch(tip))
  {
    const double depth = std::max(touch.depth, 0.0);
    const double normal = share * scene.tool.force(depth, touch.modulus);
    const double stiffness =
      share * scene.tool.stiffness(depth + RoundBody::DepthTolerance, touch.modulus);
    Fit fit;
    fit.depth = touch.depth;
    fit.tolerance = stiffness * RoundBody::DepthTolerance +
      (scene.tool.storageError() + DirectionError) * normal + Rounding;
    const double along = force.dot(touch.normal);
    const double across = (force - along * touch.normal).norm();
    fit.error = std::max(std::abs(along - normal), across - scene.friction * normal);
    if (scene.relaxation > 0.0)
    {
      // Drag: the energy that new material stores. If a fraction λ = 1 - e^(-s/2a) of an element is
      // exchanged, its energy grows by at most λ P w u²/(4 - 2 λ). Σ w u² <= δ f and λ <= s/2a. In
      // a usual tick λ is small; after a gap the displacement s may be as long as the tool.
      const double radius = scene.tool.contactRadius(depth);
      const double kept = std::exp(-contactWay(step, depth) / (2.0 * radius)); // 1 - λ
      const double drag =
        radius > 0.0 ? scene.relaxation * depth * normal / (4.0 * radius * (1.0 + kept)) : 0.0;
      const double instant = (1.0 + scene.relaxation) * normal;
      const double error = ChordError * share * scene.tool.force(ChordDepth + depth, touch.modulus);
      fit.tolerance = (1.0 + scene.relaxation) * (fit.tolerance + error);
      fit.error = std::max(
        { -along, along - instant, across - scene.friction * std::max(along, 0.0) - drag });
    }
    fit.excess = fit.error - fit.tolerance;
    fit.cap =
      normal > 0.0 ? share * scene.tool.cappedForce(depth, touch.modulus, most) / normal : 1.0;
    best = fit.excess < best.excess ? fit : best;
  }
  // A force that is not finite is always rejected.
  best.excess = force.allFinite() ? best.excess : std::numeric_limits<double>::infinity();
  return best;
}

/// Checks that the contact force matches the position of the tip. `expected` gets the
/// model's force after the stiffness cap, for checkSent.
TickVerdict TickChecker::checkPlace(const TickFacts& tick, double elapsed, Expected& expected)
{
  this->Scenes.advance(elapsed);
  const Vector3 tip = this->Frame.tip(tick.sample.position);
  if (!((tick.tip - tip).norm() <= TipRounding))
  {
    return fault(TickFault::Tip, tick, tick.tip.transpose(), " mm instead of ", tip.transpose());
  }
  // Shares are sums of many steps. They differ by the rounding of the time in each step. The forces
  // use the share that the tick reports, not the share computed here.
  const double share = tick.sceneShare;
  if (!(std::abs(share - this->Scenes.share()) <= ShareRounding && share <= 1.0))
  {
    return fault(
      TickFault::Scene, tick, "a share of ", share, " instead of ", this->Scenes.share());
  }
  const double step = (tip - this->LastTip).norm();
  this->LastTip = tip;
  const Fit newer = this->fit(this->Scenes.newer(), tip, step, tick.contactForce, 1.0);
  if (newer.excess > 0.0)
  {
    return fault(TickFault::Contact, tick, tick.contactForce.transpose(), " N at a depth of ",
      newer.depth, " mm: ", newer.excess, " N too far off");
  }
  // The rest of the force must come from the older scene. Without an older scene the rest must be
  // zero.
  const Vector3 rest = tick.idealForce - share * tick.contactForce;
  Fit older;
  older.depth = newer.depth;
  older.excess = rest.allFinite() ? rest.norm() - Rounding : rest.norm();
  if (share < 1.0 && this->Scenes.current() > 0)
  {
    older = this->fit(this->Scenes.older(), tip, step, rest, 1.0 - share);
  }
  if (!(older.excess <= 0.0))
  {
    return fault(TickFault::Contact, tick, "of the scene that is left ", rest.transpose(),
      " N at a depth of ", older.depth, " mm: ", older.excess, " N too far off");
  }
  this->Tally.nearest = std::max(this->Tally.nearest, newer.error / newer.tolerance);
  expected.force =
    this->Frame.axes.transpose() * (newer.cap * share * tick.contactForce + older.cap * rest);
  // The cap follows the stored curve, which has the same error as the force.
  expected.tolerance = 2.0 * (share * newer.tolerance + older.tolerance) + Rounding;
  const double nothing = RoundBody::DepthTolerance;
  expected.isInside = newer.depth > nothing || (older.depth > nothing && 1.0 - share > 1e-6);
  expected.isOutside = newer.depth < -nothing && older.depth < -nothing;
  expected.isBound = this->Scenes.newer().relaxation > 0.0 ||
    (share < 1.0 && this->Scenes.current() > 0 && this->Scenes.older().relaxation > 0.0);
  if (expected.isBound)
  {
    expected.force = this->Frame.axes.transpose() * tick.idealForce;
    expected.isInside = false; // the relaxing body itself determines whether there is contact
    return this->checkVisit(tick, expected.isOutside && share == 1.0);
  }
  this->Visit.lose();
  return {};
}

TickVerdict TickChecker::checkVisit(const TickFacts& tick, bool isOutside)
{
  if (this->Scenes.isChanging())
  {
    this->Visit.lose();
  }
  else if (this->Visit.move(tick.tip, tick.contactForce, isOutside))
  {
    ++this->Tally.visits;
    this->Tally.largestGain = std::max(this->Tally.largestGain, this->Visit.gain());
    if (!(this->Visit.gain() <= VisitLedger::Allowed))
    {
      return fault(
        TickFault::Energy, tick, "a visit gave ", this->Visit.gain(), " of force times way");
    }
  }
  return {};
}

/// Applies the slew limit, starting from the force sent in the previous tick, and then the limit of
/// the magnitude.
Vector3 TickChecker::limited(const Vector3& wanted, double time) const
{
  const double most = this->HasSent ? this->Limits.forceRate * (time - this->SentTime) : 0.0;
  const Vector3 change = wanted - this->Sent;
  const Vector3 slewed =
    change.norm() <= most ? wanted : Vector3(this->Sent + most * change.normalized());
  return slewed.norm() <= this->Limits.force ? slewed
                                             : Vector3(this->Limits.force * slewed.normalized());
}

TickVerdict TickChecker::checkNothing(const TickFacts& tick, const char* reason)
{
  if (!(tick.sent.array() == 0.0).all())
  {
    const TickFault kind = tick.sent.allFinite() ? TickFault::AfterLoss : TickFault::NotFinite;
    return fault(kind, tick, tick.sent.transpose(), " N, but ", reason);
  }
  return {};
}

TickVerdict TickChecker::checkBound(const TickFacts& tick, const Expected& expected)
{
  const double before = this->HasSent ? this->Sent.norm() : 0.0;
  const double rise = this->HasSent ? this->Limits.forceRate * (tick.time - this->SentTime) : 0.0;
  const double most =
    std::min({ this->Limits.force, before + rise, std::max(expected.force.norm(), before) });
  this->Tally.relaxing += (tick.sent.array() != 0.0).any() ? 1 : 0;
  if (!(tick.sent.norm() <= most + Rounding))
  {
    return fault(tick.sent.allFinite() ? TickFault::Sent : TickFault::NotFinite, tick,
      tick.sent.transpose(), " N, of at most ", most);
  }
  return {};
}

TickVerdict TickChecker::checkSent(const TickFacts& tick, const Expected& expected)
{
  this->Gate.see(expected.isInside, expected.isOutside);
  const bool isNothing = (tick.sent.array() == 0.0).all();
  TickVerdict verdict;
  if (expected.isBound)
  {
    verdict = this->checkBound(tick, expected);
  }
  else if (!this->Gate.mayPass())
  {
    ++this->Tally.shut;
    verdict = this->checkNothing(tick, "the tip has not been outside since the last loss");
  }
  else if (!this->Gate.mustPass() && isNothing)
  {
    if (expected.force.norm() > expected.tolerance)
    {
      this->Gate.settle(false);
    }
  }
  else
  {
    const Vector3 allowed = this->limited(expected.force, tick.time);
    this->Tally.free += isNothing ? 1 : 0;
    if (!isNothing)
    {
      this->Gate.settle(true);
      ++this->Tally.felt;
      this->Tally.changing += this->Scenes.isChanging() ? 1 : 0;
      this->Tally.limited += tick.isPassivityLimited ? 1 : 0;
      this->Tally.staleSeen +=
        this->HasSent && (this->Sent - allowed).norm() > expected.tolerance ? 1 : 0;
      this->Tally.largestForce = std::max(this->Tally.largestForce, tick.sent.norm());
      this->Tally.largestStep = std::max(this->Tally.largestStep, (tick.sent - this->Sent).norm());
    }
    verdict = this->compare(tick, allowed, expected.tolerance);
  }
  this->Sent = tick.sent.allFinite() ? tick.sent : Vector3(Vector3::Zero());
  this->SentTime = tick.time;
  this->HasSent = true;
  return verdict;
}

TickVerdict TickChecker::compare(const TickFacts& tick, const Vector3& allowed, double tolerance)
{
  if (!tick.sent.allFinite())
  {
    return fault(TickFault::NotFinite, tick, tick.sent.transpose());
  }
  Vector3 nearest = allowed;
  if (tick.isPassivityLimited && allowed.norm() > 0.0)
  {
    const Vector3 direction = allowed.normalized();
    nearest = std::clamp(tick.sent.dot(direction), 0.0, allowed.norm()) * direction;
  }
  const double excess = (tick.sent - nearest).norm() - tolerance;
  this->Tally.largestExcess = std::max(this->Tally.largestExcess, excess);
  if (excess > 0.0)
  {
    return fault(TickFault::Sent, tick, tick.sent.transpose(), " N instead of ",
      nearest.transpose(), tick.isPassivityLimited ? " or less" : "", ": ", excess,
      " N too far off");
  }
  return {};
}
} // namespace palpate::endurance
