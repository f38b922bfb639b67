// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Relaxation/ContactRelaxation.h"

#include "Contact/CappedResponse.h"
#include "Mechanics/Numerics/IncreasingRoot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Nowhere = -std::numeric_limits<double>::infinity();

/// Fraction of the contact area that is new material after a path of length `way`, for the contact
/// radius `radius`: 1 - e^(-way/2a).
double shareOfWay(double way, double radius) noexcept
{
  const double x = 0.5 * way / radius;
  return x * RelaxationStep::meanDecay(x);
}
} // namespace

ContactRelaxation::ContactRelaxation(const BodyRelaxation* body, int elements) noexcept
  : Body(body)
  , Nodes(body ? ForceNodes(body->curves().sampling(), body->range(), std::max(elements, 1))
               : ForceNodes())
  , IsOne(elements <= 0 || (body && !body->areConvex()))
{
  const std::int32_t same = body && !this->IsOne ? body->sameEverywhere() : -1;
  if (same >= 0)
  {
    const BlendedResponse curve(body->curves(), { same, same, same }, { 1.0, 0.0, 0.0 });
    this->Nodes.chordsOf(curve, this->Nodes.count(), this->Chords);
    this->HasChords = true;
  }
}

void ContactRelaxation::reset() noexcept
{
  this->Elements.reset();
  this->Rest.reset();
  this->One.reset();
  this->Elapsed = 0.0;
  this->OneDepth = 0.0;
  this->OneSlow = 0.0;
  this->HasBegun = false;
  this->Depth = 0.0;
  this->LastRest = 0.0;
  this->lose();
}

void ContactRelaxation::beginTick() noexcept
{
  if (this->Elapsed != this->StepTime)
  {
    this->Step = RelaxationStep(this->Body->series(), this->Elapsed);
    this->StepTime = this->Elapsed;
  }
  this->Elapsed = 0.0;
}

void ContactRelaxation::lift() noexcept
{
  if (!this->IsInTime)
  {
    return;
  }
  if (this->HasBegun)
  {
    this->beginTick();
    this->Elements.relax(this->Step);
    this->Elements.press(Nowhere, this->Nodes.gaps(), this->Step);
    this->Rest.follow(-this->LastRest, this->Step);
    this->One.press(0.0, this->Step);
  }
  this->Elapsed = 0.0;
  this->HasBegun = true;
  this->Depth = 0.0;
  this->LastRest = 0.0;
  this->lose();
}

void ContactRelaxation::jumpTo(const Place& place) noexcept
{
  const double deeper = std::max(place.deflection, this->Last.deflection);
  const double radius = this->Body->contactRadius(deeper);
  if (radius > 0.0)
  {
    this->exchange(shareOfWay((place.point - this->Last.point).norm(), radius));
  }
}

void ContactRelaxation::exchange(double share) noexcept
{
  if (this->IsOne)
  {
    this->One.exchange(share);
    return;
  }
  this->Elements.exchange(share, this->Step.count);
  this->Rest.exchange(share);
}

ContactRelaxation::Force ContactRelaxation::press(
  const Place& place, const ResponseValue& slow) noexcept
{
  const BlendedResponse curve(this->Body->curves(), place.corners, place.weights);
  this->Compliance = this->Body->elasticCompliance(place.corners, place.weights);
  this->beginTick();
  if (this->Body->isPerPoint())
  {
    this->Step.setStrength(this->Body->strength(place.corners, place.weights));
  }
  if (!this->HasBegun)
  {
    const double depth = place.deflection - this->Compliance * slow.force;
    this->Elements.rest(depth, this->Nodes.gaps());
    this->One.rest(slow.force);
    this->Depth = this->OneDepth = depth;
    this->OneSlow = slow.force;
    this->LastRest = this->HasChords ? this->restAt(curve, depth) : 0.0;
    this->HasBegun = true;
  }
  else if (!this->WasTouched)
  {
    this->jumpTo(place);
  }
  this->Last = place;
  this->Now = {};
  if (this->IsOne)
  {
    this->pressOne(curve, slow);
  }
  else
  {
    this->pressElements(curve, slow);
  }
  this->WasTouched = this->Now.isTouched;
  if (this->Compliance > 0.0)
  {
    this->Now.stiffness /= 1.0 + this->Compliance * this->Now.stiffness;
  }
  return this->Now;
}

void ContactRelaxation::pressElements(
  const BlendedResponse& curve, const ResponseValue& slow) noexcept
{
  const double tip = this->Last.deflection;
  this->Elements.relax(this->Step);
  double before = this->LastRest;
  if (!this->HasChords)
  {
    std::size_t used = this->Elements.awake();
    while (used < this->Nodes.count() && tip > this->Nodes.gaps()[used])
    {
      ++used;
    }
    this->Nodes.chordsOf(curve, used, this->Chords);
    // Evaluated on the curve of this tick, because the difference between this curve and the last
    // one is not an increment of the force.
    before = this->Depth > 0.0 ? this->restAt(curve, this->Depth) : 0.0;
  }
  this->LastRest = before;
  this->Depth = this->Compliance > 0.0 ? this->localDepth(curve) : tip;
  const ResponseValue value = this->Body->isInSeries() ? curve.evaluate(this->Depth) : slow;
  this->Slow = value.force;
  this->Stiffness = value.stiffness;
  this->LastRest = value.force - this->Nodes.slowForce(this->Chords, this->Depth);
  this->RestMemory = this->Rest.follow(this->LastRest - before, this->Step);
  this->Elements.press(this->Depth, this->Nodes.gaps(), this->Step);
  const double force =
    this->Elements.forceOf(this->Chords.weight) + this->LastRest + this->RestMemory;
  if (!this->Elements.isTouched())
  {
    return;
  }
  const double touched = this->Elements.touchedStiffness(this->Chords.weight);
  const double chord =
    this->Depth > 0.0 ? this->Chords.slope[this->Nodes.chordAt(this->Depth)] : 0.0;
  this->Now = { std::max(force, 0.0),
    (1.0 + this->Step.stiffening) * (touched + value.stiffness - chord), true };
}

double ContactRelaxation::localDepth(const BlendedResponse& curve) const noexcept
{
  const double tip = this->Last.deflection;
  const double compliance = this->Compliance;
  const auto forceAt = [&](double depth)
  {
    const double rest = this->restAt(curve, depth);
    const double force =
      this->Elements.forceAt(depth, this->Nodes.gaps(), this->Chords.weight, this->Step) + rest +
      this->Rest.foresee(rest - this->LastRest, this->Step);
    return std::max(force, 0.0);
  };
  const double atTip = forceAt(tip);
  if (!(atTip > 0.0))
  {
    return tip;
  }
  // The force increases with the depth, so that the root is between these bounds. The slope is
  // discontinuous; therefore a bracketed secant method (Illinois) finds the root.
  double high = tip;
  double overHigh = compliance * atTip;
  double low = tip - overHigh;
  double overLow = compliance * forceAt(low) - overHigh;
  constexpr int most = 60;
  const double enough = 1e-14 * tip;
  for (int i = 0, side = 0; i < most && high - low > enough && overLow < 0.0; ++i)
  {
    const double depth = (low * overHigh - high * overLow) / (overHigh - overLow);
    const double over = depth + compliance * forceAt(depth) - tip;
    if (std::abs(over) <= enough)
    {
      return depth;
    }
    if (over > 0.0)
    {
      high = depth;
      overHigh = over;
      overLow *= side > 0 ? 0.5 : 1.0;
      side = 1;
    }
    else
    {
      low = depth;
      overLow = over;
      overHigh *= side < 0 ? 0.5 : 1.0;
      side = -1;
    }
  }
  return overLow < 0.0 ? 0.5 * (low + high) : low;
}

void ContactRelaxation::pressOne(const BlendedResponse& curve, const ResponseValue& slow) noexcept
{
  // Scales the stored force to the curve of this tick.
  const double same = this->OneDepth > 0.0 ? curve.evaluate(this->OneDepth).force : 0.0;
  if (same > 0.0 && this->OneSlow > 0.0)
  {
    this->One.scale(same / this->OneSlow);
  }
  const double tip = this->Last.deflection;
  this->Depth = tip;
  if (this->Compliance > 0.0)
  {
    const QuasiLinearElement before = this->One;
    const RelaxationStep& step = this->Step;
    const double compliance = this->Compliance;
    this->Depth = increasingRoot(
      [&](double depth) -> ValueAndSlope
      {
        const ResponseValue value = curve.evaluate(depth);
        QuasiLinearElement trial = before;
        const double force = trial.press(value.force, step);
        const double slope = force > 0.0 ? (1.0 + step.stiffening) * value.stiffness : 0.0;
        return { depth + compliance * force - tip, 1.0 + compliance * slope };
      },
      0.0, tip, tip);
  }
  const ResponseValue value = this->Body->isInSeries() ? curve.evaluate(this->Depth) : slow;
  this->Slow = value.force;
  this->Stiffness = value.stiffness;
  this->OneDepth = this->Depth;
  this->OneSlow = value.force;
  const double force = this->One.press(value.force, this->Step);
  if (force > 0.0)
  {
    this->Now = { force, (1.0 + this->Step.stiffening) * value.stiffness, true };
  }
}

double ContactRelaxation::secantCompliance() const noexcept
{
  // For f ∝ δ^m this is 2 e/f², where e is the work of f.
  return this->Slow > 0.0 ? 2.0 * this->Depth / ((this->Body->exponent() + 1.0) * this->Slow) : 0.0;
}

Vector3 ContactRelaxation::drag(const Vector3& contactPoint, const Vector3& normal) noexcept
{
  // Ratio of tangential to normal stiffness: 2 (1-ν)/(2-ν) for a flat end, here for an
  // incompressible body.
  constexpr double tangential = 2.0 / 3.0;
  const double way = this->Drag.advance(contactPoint, normal);
  const double radius = this->Body->contactRadius(this->Depth);
  if (!(radius > 0.0))
  {
    return Vector3::Zero();
  }
  const double share = shareOfWay(way, radius);
  const double growth = this->IsOne
    ? this->One.growthByExchange(this->Step, share) * this->secantCompliance()
    : this->Elements.growthByExchange(this->Chords.weight, this->Step, share);
  const double limit = std::max(growth, 0.0) / (2.0 * radius);
  const double slid = this->Drag.slide(limit, tangential * this->Stiffness);
  if (slid > 0.0)
  {
    this->exchange(slid == way ? share : shareOfWay(slid, radius));
  }
  return this->Drag.force();
}

double ContactRelaxation::cappedShare(
  const BlendedResponse& curve, double depth, double maximumStiffness) const noexcept
{
  if (!this->IsInTime)
  {
    return CappedResponse(curve, maximumStiffness).share(depth);
  }
  const double cap = maximumStiffness / this->stiffening();
  const double whole = this->Now.total;
  const double capped = this->cappedForce(CappedResponse(curve, cap).evaluate(depth).force, cap);
  return std::min(1.0, whole > 0.0 ? capped / whole : 1.0);
}

double ContactRelaxation::cappedForce(double cappedSlow, double maximumStiffness) const noexcept
{
  if (!(this->Now.total > 0.0) || !(this->Slow > 0.0))
  {
    return 0.0;
  }
  if (this->IsOne)
  {
    return this->Now.total * std::min(1.0, cappedSlow / this->Slow);
  }
  double most = maximumStiffness;
  const double soft = 1.0 - most * this->Compliance;
  most = soft > 0.0 ? most / soft : std::numeric_limits<double>::infinity();
  RelaxationElements::Values weights{};
  double before = 0.0;
  for (std::size_t j = 0; j < this->Elements.awake(); ++j)
  {
    const double slope = std::min(this->Chords.slope[j], most);
    weights[j] = slope - before;
    before = slope;
  }
  const double memory = this->Elements.memoryOf(weights, this->Depth, this->Nodes.gaps()) +
    this->RestMemory * std::min(1.0, cappedSlow / this->Slow);
  return std::clamp(cappedSlow + memory, 0.0, this->Now.total);
}

double ContactRelaxation::stiffening() const noexcept
{
  const double felt = this->Step.sampledStiffening();
  // The force of the single element is multiplied by the ratio of the capped to the full slow
  // force. Therefore its memory acts m times as stiff.
  return this->IsOne ? 1.0 + std::max(this->Body->exponent(), 1.0) * (felt - 1.0) : felt;
}

double ContactRelaxation::storedEnergy() const noexcept
{
  return this->IsOne ? this->One.storedEnergy(this->Step) * this->secantCompliance()
                     : this->Elements.storedEnergy(this->Chords.weight, this->Step);
}

Vector3 ContactRelaxation::strengthEnergies() const noexcept
{
  Vector3 energies = Vector3::Zero();
  if (!this->Body->isPerPoint())
  {
    return energies;
  }
  for (std::size_t i = 0; i < this->Step.count; ++i)
  {
    const double stored = this->IsOne ? this->One.energyByStrength(i) * this->secantCompliance()
                                      : this->Elements.energyByStrength(this->Chords.weight, i);
    for (std::size_t k = 0; k < 3; ++k)
    {
      energies[static_cast<Eigen::Index>(k)] +=
        stored * this->Body->strength(this->Last.corners[k])[i];
    }
  }
  return energies;
}
} // namespace palpate
