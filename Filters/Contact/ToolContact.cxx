// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ToolContact.h"

#include "Contact/BorderFade.h"
#include "Contact/EnergyGradient.h"
#include "Contact/ForceDirection.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
using Outcome = ContactTracker::Outcome;

void ToolContact::reset() noexcept
{
  this->lose();
  this->Relaxation.reset();
}

void ToolContact::lose() noexcept
{
  this->Tracker.reset();
  this->Resistance.reset();
  this->Relaxation.lose();
  this->LastWeights.setZero();
  this->Edges = EdgeMode::Active;
}

[[gnu::hot]] Pressed ToolContact::find(const ToolPose& pose) noexcept
{
  this->Relaxation.setInTime(false);
  return this->follow(pose);
}

[[gnu::hot]] Pressed ToolContact::find(const ToolPose& pose, double elapsed) noexcept
{
  this->pass(elapsed);
  this->Relaxation.setInTime(true);
  return this->follow(pose);
}

[[gnu::hot]] inline Pressed ToolContact::follow(const ToolPose& pose) noexcept
{
  const std::int32_t last = this->Tracker.triangle();
  if (last >= 0) // the contact is probably again on this triangle or on a neighbour of it
  {
    this->Body.prefetchResponses(last);
  }
  const Vector3 followed = this->Tilt.follow(pose, last >= 0);
  this->LastStep = followed - this->LastTip;
  this->LastTip = followed;
  Pressed at{ this->Tracker.update(followed), last < 0 };
  if (this->Edges == EdgeMode::Ignored && at.found.outcome == Outcome::Crease)
  {
    this->Tracker.reset();
    at.found = this->Tracker.update(followed);
  }
  return at;
}

[[gnu::hot]] Contact ToolContact::feel(Pressed& at, double lowering) noexcept
{
  this->LastWeights.setZero();
  if (at.found.outcome == Outcome::Invalid)
  {
    return this->end(ContactState::Invalid);
  }
  if (at.found.outcome == Outcome::Outside)
  {
    this->Edges = EdgeMode::Active;
    return this->end(ContactState::None);
  }
  if (this->Edges == EdgeMode::Released)
  {
    this->Tracker.reset();
    return this->end(ContactState::None);
  }
  this->reach(at, lowering);
  if (at.reach.nearerAcross >= 0)
  {
    this->crossEdges(at, lowering);
  }
  if (!at.presses())
  {
    return this->endAtDepth(at, lowering);
  }
  Contact result;
  if (!this->hasResponse(at.place()) || !this->push(at, result))
  {
    return this->end(at.isAtBorder ? ContactState::LostAtBorder : ContactState::Invalid);
  }
  if (result.state == ContactState::None)
  {
    return this->endDetached();
  }
  this->addFriction(result);
  if (at.isAtBorder)
  {
    result.state = ContactState::LostAtBorder;
  }
  return result;
}

[[gnu::hot]] inline void ToolContact::reach(Pressed& at, double lowering) noexcept
{
  ContactPlace& place = at.place();
  const PackedMesh& surface = this->Body.surface;
  at.isAtBorder = at.found.outcome == Outcome::Border;
  at.isAtEdges = this->Body.edges && this->Edges == EdgeMode::Active &&
    (at.found.outcome == Outcome::Crease ||
      (at.found.outcome == Outcome::Inside && this->Body.edges->areNear(place.triangle)));
  at.sunk = lowering +
    this->Tilt.lean(surface.corners(place.triangle), place.projection.weights, this->Body.response);
  if (!place.isSmooth && (at.isAtEdges || this->Settings.form == ForceForm::EnergyConsistent))
  {
    place = EnergyGradient::onFacet(surface, this->LastTip, place);
  }
  if (at.isAtBorder)
  {
    BorderFade::reach(surface, this->LastTip, at);
  }
  else if (at.isAtEdges)
  {
    this->Body.edges->reach(surface, this->LastTip, at);
  }
  else
  {
    at.reach.depth = -(place.signedDistance + at.sunk);
  }
  if (this->usesGradients(place))
  {
    this->Tilt.changeToTip(
      place.weightGradients, surface.corners(place.triangle), this->Body.response);
  }
}

void ToolContact::crossEdges(Pressed& at, double lowering) noexcept
{
  constexpr int others = 2; // largest number of other faces at a corner
  for (int face = 0; face < others && at.reach.depth > 0.0 && at.reach.nearerAcross >= 0; ++face)
  {
    const ContactTracker::Result across =
      this->Tracker.handOver(this->LastTip, at.reach.nearerAcross);
    if (across.outcome != Outcome::Inside)
    {
      break;
    }
    at = { across, at.isNew };
    this->reach(at, lowering);
  }
}

[[gnu::hot]] inline bool ToolContact::push(const Pressed& at, Contact& result) noexcept
{
  const ContactPlace& place = at.place();
  const ContactReach& reach = at.reach;
  this->LastCorners = this->Body.surface.corners(place.triangle);
  this->LastWeights = place.projection.weights;
  result.triangle = this->Body.surface.inputTriangle(place.triangle);
  result.contactPoint = place.projection.point;
  result.deflection = reach.depth;
  const ResponseValue upright = this->response().evaluate(reach.depth);
  result.state = upright.beyondRange ? ContactState::BeyondRange : ContactState::Slide;

  Jet work = this->slowWork(at, reach.depth, upright);
  this->Slow = { work.byDepth, work.byDepthTwice, false };
  if (this->Relaxation.isInTime())
  {
    this->addMemory(work, at, result);
  }
  const double whole = work.byDepth; // normal force without the effect of edges and borders, N
  const Vector3 out = this->vectorToContact(place);
  const ForceDirection direction = ForceDirection::of(
    this->Settings.form, this->Body.response, this->LastCorners, at, upright.force, out);
  work.byDepth *= direction.ratio;
  result.normal = direction.normal;
  double slope = 1.0; // |∇δ|
  if (at.isAtEdges || at.isAtBorder)
  {
    work *= reach.share;
  }
  if (at.isAtEdges)
  {
    result.normal = reach.ownNormal * direction.normal + reach.otherNormals;
    slope = result.normal.norm();
    result.normal /= slope;
  }
  result.normalForce = work.byDepth * slope;
  result.stiffness = work.byDepthTwice * slope * slope;
  if (this->Relaxation.isInTime())
  {
    result.memory *= whole > 0.0 ? result.normalForce / whole : reach.share.value;
  }
  result.force = result.normalForce * result.normal - work.byPlace;
  if (at.isAtEdges && result.force.dot(out) < 0.0)
  {
    result.force = ForceDirection::outwardPart(result.force, out);
    result.normalForce = result.force.norm();
    result.normal =
      result.normalForce > 0.0 ? Vector3(result.force / result.normalForce) : result.normal;
  }
  this->Tilt.addTorque(work, this->LastCorners,
    this->usesGradients(place) ? &place.weightGradients : nullptr, this->Body.response, result);
  return result.force.allFinite();
}

[[gnu::hot, gnu::always_inline]] inline Jet ToolContact::slowWork(
  const Pressed& at, double depth, const ResponseValue& upright) const noexcept
{
  const ContactPlace& place = at.place();
  const BlendedResponse curves = this->curvesAt(place);
  const bool hasEnergy = this->Settings.form == ForceForm::EnergyConsistent;
  const bool isValueUsed =
    at.isAtEdges || this->Tilt.isTilted() || (hasEnergy && this->Relaxation.isInTime());
  Jet work;
  work.value = isValueUsed ? curves.energy(depth) : 0.0;
  work.byDepth = upright.force;
  work.byDepthTwice = upright.stiffness;
  if (hasEnergy)
  {
    work.byPlace = EnergyGradient::ofEnergies(place.weightGradients, curves.energies(depth));
  }
  this->Tilt.multiply(work, this->Body.surface.corners(place.triangle), place.projection.weights,
    depth, hasEnergy ? &place.weightGradients : nullptr);
  return work;
}

void ToolContact::addMemory(Jet& work, const Pressed& at, Contact& result) noexcept
{
  const Jet slow = work;
  // The material under a tilted tool has moved in the same way as under an upright tool with the
  // same force.
  const ContactTilt::Alike upright =
    this->Tilt.alike(this->response(), result.deflection, this->Slow);
  const ContactRelaxation::Force felt = this->Relaxation.press(
    { this->LastCorners, this->LastWeights, result.contactPoint, upright.depth }, upright.value);
  result.state = felt.isTouched ? result.state : ContactState::None;
  result.memory = felt.total - slow.byDepth;
  // A tilted tool stores more energy than the upright one, in the ratio of their slow works.
  const double stretch = this->Tilt.isTilted() && slow.value > 0.0
    ? slow.value / this->response().energy(upright.depth)
    : 1.0;
  if (slow.value > 0.0) // otherwise work.value is not used
  {
    work.value += stretch * this->Relaxation.storedEnergy();
  }
  if (this->Settings.form == ForceForm::EnergyConsistent)
  {
    // The energy stored by the memory force is divided among the corners in proportion to their
    // slow works, because the curves of one tool on bodies of different stiffness have the same
    // shape.
    work.byPlace *= slow.value > 0.0 ? work.value / slow.value : 1.0;
    work.byPlace += stretch *
      EnergyGradient::ofEnergies(at.place().weightGradients, this->Relaxation.strengthEnergies());
  }
  work.byTilt *= slow.byDepth > 0.0 ? felt.total / slow.byDepth : 1.0;
  work.byDepth = felt.total;
  work.byDepthTwice = felt.stiffness * upright.stiffening;
}

[[gnu::hot]] inline void ToolContact::addFriction(Contact& result) noexcept
{
  result.friction = this->Relaxation.slide(result.contactPoint, result.normal);
  if (this->Settings.friction.coefficient > 0.0)
  {
    const Friction::Result friction = this->Resistance.update(
      result.contactPoint, result.normal, result.normalForce, result.deflection, this->response());
    // Without time the force is copied, which keeps the sign of -0.
    result.friction =
      this->Relaxation.isInTime() ? Vector3(result.friction + friction.force) : friction.force;
    if (!friction.sliding && result.state == ContactState::Slide)
    {
      result.state = ContactState::Stick;
    }
  }
  result.force += result.friction;
}

bool ToolContact::press(Pressed& at) noexcept
{
  if (at.found.outcome == Outcome::Outside || at.found.outcome == Outcome::Invalid ||
    !this->hasResponse(at.place()))
  {
    return false;
  }
  this->reach(at, 0.0);
  return at.reach.depth > 0.0 && at.reach.share.value > 0.0;
}

ResponseValue ToolContact::slowResponse(const Pressed& at, double depth) const noexcept
{
  const ResponseValue upright = this->curvesAt(at.place()).evaluate(depth);
  if (!(depth > 0.0))
  {
    return upright;
  }
  Jet work = this->slowWork(at, depth, upright);
  work *= at.reach.share;
  return { work.byDepth, work.byDepthTwice, upright.beyondRange };
}

[[gnu::hot]] double ToolContact::cappedShare(
  const Contact& contact, double maximumStiffness) const noexcept
{
  if (!(contact.normalForce > 0.0))
  {
    return 1.0;
  }
  const BlendedResponse curve = this->response();
  const ContactTilt::Alike upright = this->Tilt.alike(curve, contact.deflection, this->Slow);
  return this->Relaxation.cappedShare(
    curve, upright.depth, maximumStiffness / std::max(upright.stiffening, 1e-9));
}

Contact ToolContact::endAtDepth(const Pressed& at, double lowering) noexcept
{
  if (!at.isAtEdges)
  {
    return this->end(at.isAtBorder ? ContactState::LostAtBorder : ContactState::None);
  }
  const bool isLowered = at.reach.depth + at.sunk > 0.0 && at.reach.share.value > 0.0;
  if (!isLowered && at.isNew)
  {
    this->Edges = EdgeMode::Ignored;
    this->Tracker.reset();
    Pressed again{ this->Tracker.update(this->LastTip) };
    return this->feel(again, lowering);
  }
  if (!isLowered)
  {
    this->Tracker.reset();
    this->Edges = EdgeMode::Released;
  }
  return this->end(ContactState::None);
}

Contact ToolContact::end(ContactState state) noexcept
{
  this->Resistance.reset();
  if (state != ContactState::Invalid)
  {
    this->Relaxation.lift();
  }
  Contact none;
  none.state = state;
  return none;
}

Contact ToolContact::endDetached() noexcept
{
  this->Resistance.reset();
  this->Relaxation.lose();
  this->LastWeights.setZero();
  return {};
}

// A tick on a new triangle would wait for the memory of the triangle, and then for that of its new
// corner. A prefetch does not wait.
void ToolContact::foresee() const noexcept
{
  const std::int32_t triangle = this->Tracker.triangleAhead(this->LastTip + this->LastStep);
  if (triangle >= 0)
  {
    this->Body.prefetchAround(triangle);
  }
}

void ToolContact::rehearse(double elapsed) const noexcept
{
  ToolContact scratch(*this);
  const ToolPose ahead(this->LastTip + this->LastStep);
  this->Relaxation.isInTime() ? scratch.update(ahead, elapsed) : scratch.update(ahead);
}

[[gnu::hot]] inline Vector3 ToolContact::vectorToContact(const ContactPlace& place) const noexcept
{
  constexpr double rounding = 1e-9; // mm; the direction of a shorter vector is uncertain
  const Vector3 way = place.projection.point - this->LastTip;
  return way.squaredNorm() > rounding * rounding ? way
                                                 : this->Body.surface.areaNormal(place.triangle);
}

[[gnu::hot]] inline bool ToolContact::hasResponse(const ContactPlace& place) const noexcept
{
  const TriangleCorners& corners = this->Body.surface.corners(place.triangle);
  bool valid = true;
  for (std::size_t k = 0; k < 3; ++k)
  {
    // If the contact is on an edge, the opposite corners of both triangles have no effect.
    valid = valid &&
      (place.projection.weights[static_cast<Eigen::Index>(k)] == 0.0 ||
        this->Body.response.isValid(corners[k]));
  }
  return valid;
}
} // namespace palpate
