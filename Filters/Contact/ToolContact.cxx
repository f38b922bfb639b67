// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ToolContact.h"

#include "Contact/BorderFade.h"
#include "Contact/CappedResponse.h"
#include "Contact/EnergyGradient.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
Contact withoutForce(ContactState state) noexcept
{
  Contact none;
  none.state = state;
  return none;
}

ContactState stateOf(ContactTracker::Outcome outcome) noexcept
{
  switch (outcome)
  {
    case ContactTracker::Outcome::Border:
      return ContactState::LostAtBorder;
    case ContactTracker::Outcome::Invalid:
      return ContactState::Invalid;
    default:
      return ContactState::None;
  }
}
} // namespace

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
  this->IsLetGo = false;
}

ContactTracker::Result ToolContact::find(const ToolPose& pose) noexcept
{
  this->IsInTime = false;
  return this->follow(pose);
}

ContactTracker::Result ToolContact::find(const ToolPose& pose, double elapsed) noexcept
{
  this->pass(elapsed);
  this->IsInTime = this->Relaxation.isFelt();
  return this->follow(pose);
}

ContactTracker::Result ToolContact::follow(const ToolPose& pose) noexcept
{
  this->prefetchLast();
  const Vector3 followed = this->Tilt.follow(pose, this->Tracker.triangle() >= 0);
  this->LastStep = followed - this->LastTip;
  this->LastTip = followed;
  return this->Tracker.update(followed);
}

void ToolContact::sink(const ContactPlace& place) noexcept
{
  this->Sunk = this->LetDown + this->underTool(place);
}

ResponseValue ToolContact::slowResponse(const ContactPlace& place, double depth) const noexcept
{
  const TriangleCorners& corners = this->Body.surface.corners(place.triangle);
  const Vector3& weights = place.projection.weights;
  const BlendedResponse response(this->Body.response, corners, weights);
  const ResponseValue upright = response.evaluate(depth);
  return this->Tilt.isTilted() && depth > 0.0
    ? this->Tilt.tilted(corners, weights, depth, upright, response.energy(depth))
    : upright;
}

Eigen::Matrix3d ToolContact::weightGradients(const ContactPlace& place) const noexcept
{
  return this->Tilt.isFelt() ? this->Tilt.ofTip(place.weightGradients,
                                 this->Body.surface.corners(place.triangle), this->Body.response)
                             : place.weightGradients;
}

Contact ToolContact::feel(ContactTracker::Result found, double sunk) noexcept
{
  auto& [outcome, place] = found;
  this->LetDown = sunk;
  this->LastWeights.setZero();
  this->IsLetGo = this->IsLetGo && outcome != ContactTracker::Outcome::Outside;
  if (this->IsLetGo && outcome != ContactTracker::Outcome::Invalid)
  {
    this->Tracker.reset();
    return this->end(ContactState::None);
  }
  if (outcome != ContactTracker::Outcome::Outside && outcome != ContactTracker::Outcome::Invalid)
  {
    this->sink(place);
  }
  if (outcome == ContactTracker::Outcome::Border)
  {
    return this->fade(place);
  }
  if (outcome == ContactTracker::Outcome::Crease ||
    (outcome == ContactTracker::Outcome::Inside && this->Body.edges &&
      this->Body.edges->areNear(place.triangle)))
  {
    return this->feelEdges(place);
  }
  if (outcome != ContactTracker::Outcome::Inside)
  {
    return this->end(stateOf(outcome));
  }
  if (this->Settings.form == ForceForm::EnergyConsistent &&
    this->Settings.surface == ContactSurface::Facets)
  {
    place = EnergyGradient::onFacet(this->Body.surface, this->LastTip, place);
  }
  place.signedDistance += this->Sunk;
  if (place.signedDistance > 0.0)
  {
    return this->end(ContactState::None);
  }
  Contact result;
  const BlendedResponse response(
    this->Body.response, this->Body.surface.corners(place.triangle), place.projection.weights);
  if (!this->hasResponse(place) || !this->blend(place, response, result))
  {
    return this->end(ContactState::Invalid);
  }
  if (result.state == ContactState::None)
  {
    return this->comeOff();
  }
  this->complete(place, response, 1.0, result);
  return result;
}

Contact ToolContact::end(ContactState state) noexcept
{
  this->Resistance.reset();
  if (this->IsInTime && state != ContactState::Invalid)
  {
    this->Relaxation.lift();
  }
  return withoutForce(state);
}

Contact ToolContact::comeOff() noexcept
{
  this->Resistance.reset();
  this->Relaxation.lose();
  this->LastWeights.setZero();
  return withoutForce(ContactState::None);
}

EdgeEffect ToolContact::edgeEffect(ContactPlace& place) const noexcept
{
  const Vector3 tip = this->LastTip; // of facets, the point followed
  if (!place.isSmooth)
  {
    // Beyond a crease its plane goes on.
    place = EnergyGradient::onFacet(this->Body.surface, tip, place);
    place.normal = place.onCrease ? this->Body.surface.faceNormal(place.triangle) : place.normal;
  }
  const Vector3 pressed = tip + this->Sunk * place.normal;
  const double depth = place.normal.dot(place.projection.point - pressed);
  return this->Body.edges->at(
    this->Body.surface.toLocal(pressed), place.triangle, place.normal, depth);
}

EdgeEffect ToolContact::onNearestFace(ContactPlace& place) noexcept
{
  constexpr int others = 2; // at a corner
  EdgeEffect effect = this->edgeEffect(place);
  for (int face = 0; face < others && effect.depth > 0.0 && effect.nearerAcross >= 0; ++face)
  {
    const ContactTracker::Result across =
      this->Tracker.handOver(this->LastTip, effect.nearerAcross);
    if (across.outcome != ContactTracker::Outcome::Inside)
    {
      break;
    }
    place = across.place;
    this->sink(place);
    effect = this->edgeEffect(place);
  }
  return effect;
}

Contact ToolContact::feelEdges(ContactPlace& place) noexcept
{
  const EdgeEffect effect = this->onNearestFace(place);
  if (!(effect.depth > 0.0) && effect.depth + this->Sunk > 0.0 && effect.share > 0.0)
  {
    return this->end(ContactState::None); // under the tool, and not up to it
  }
  if (!(effect.depth > 0.0 && effect.share > 0.0))
  {
    this->Tracker.reset();
    this->IsLetGo = true;
    return this->end(ContactState::None);
  }
  place.signedDistance = -effect.depth;
  const BlendedResponse response(
    this->Body.response, this->Body.surface.corners(place.triangle), place.projection.weights);
  Contact result;
  if (!this->hasResponse(place) || !this->blend(place, response, result))
  {
    return this->end(ContactState::Invalid);
  }
  if (result.state == ContactState::None)
  {
    return this->comeOff();
  }
  this->applyEdges(effect, response, result);
  this->complete(place, response, effect.share, result);
  return result;
}

void ToolContact::applyEdges(
  const EdgeEffect& effect, const BlendedResponse& response, Contact& result) const noexcept
{
  const double work =
    this->work(response, effect.depth) + (this->IsInTime ? this->Relaxation.storedEnergy() : 0.0);
  const double before = result.normalForce;
  const Vector3 beside = result.force - result.normalForce * result.normal; // of unlike curves
  const double force = result.normalForce * effect.share + work * effect.byDepth;
  result.stiffness = result.stiffness * effect.share + 2.0 * result.normalForce * effect.byDepth +
    work * effect.byDepthTwice;
  result.normal = effect.ownNormal * result.normal + effect.otherNormals;
  result.force = force * result.normal + effect.share * beside - work * effect.byPlace;
  const double length = result.normal.norm();
  result.normal /= length;
  result.normalForce = force * length;
  result.stiffness *= length * length;
  result.memory *= before > 0.0 ? result.normalForce / before : 0.0;
}

Contact ToolContact::fade(ContactPlace& place) noexcept
{
  const BorderFade left = BorderFade::at(this->Body.surface, place.triangle,
    place.projection.weights, this->LastTip - place.projection.point);
  const BlendedResponse response(
    this->Body.response, this->Body.surface.corners(place.triangle), place.projection.weights);
  place.signedDistance = this->Sunk - left.depth;
  place.normal = this->Body.surface.faceNormal(place.triangle);
  place.weightGradients.setZero();
  Contact result;
  if (!(left.fraction > 0.0) || place.signedDistance > 0.0 || !this->hasResponse(place) ||
    !this->blend(place, response, result))
  {
    return this->end(ContactState::LostAtBorder);
  }
  if (result.state == ContactState::None)
  {
    return this->comeOff();
  }
  result.memory *= left.fraction;
  result.normalForce *= left.fraction;
  result.stiffness *= left.fraction;
  result.force *= left.fraction;
  this->complete(place, response, left.fraction, result);
  result.state = ContactState::LostAtBorder;
  return result;
}

void ToolContact::prefetchLast() const noexcept
{
  const std::int32_t triangle = this->Tracker.triangle();
  // The contact is likely there again, or next to it: its responses come while it is sought.
  if (triangle >= 0)
  {
    this->prefetchResponses(triangle);
  }
}

void ToolContact::prefetchResponses(std::int32_t triangle) const noexcept
{
  for (const std::int32_t corner : this->Body.surface.corners(triangle))
  {
    this->Body.response.prefetch(corner);
  }
}

// A tick on new ground would wait for the triangle, then for its new corner: here nobody waits.
void ToolContact::foresee() const noexcept
{
  const PackedMesh& surface = this->Body.surface;
  const std::int32_t triangle = this->Tracker.triangleAhead(this->LastTip + this->LastStep);
  if (triangle < 0)
  {
    return;
  }
  const auto ask = [this, &surface](std::int32_t likely)
  {
    surface.prefetchInput(likely);
    if (this->Body.edges)
    {
      this->Body.edges->prefetch(likely);
    }
    this->prefetchResponses(likely);
  };
  ask(triangle);
  for (int edge = 0; edge < 3; ++edge)
  {
    const std::int32_t across = surface.neighbour(triangle, edge);
    if (across >= 0)
    {
      ask(across);
    }
  }
  // Where a face is not certain to be nearest, the tick looks at those around its corners.
  for (const std::int32_t corner : surface.corners(triangle))
  {
    surface.visitAround(corner, [&surface](std::int32_t near) { surface.prefetch(near); });
  }
}

bool ToolContact::hasResponse(const ContactPlace& place) const noexcept
{
  const TriangleCorners& corners = this->Body.surface.corners(place.triangle);
  bool valid = true;
  for (std::size_t k = 0; k < 3; ++k)
  {
    // On an edge, neither neighbour's opposite corner has a say.
    valid = valid &&
      (place.projection.weights[static_cast<Eigen::Index>(k)] == 0.0 ||
        this->Body.response.isValid(corners[k]));
  }
  return valid;
}

bool ToolContact::blend(
  const ContactPlace& place, const BlendedResponse& response, Contact& result) noexcept
{
  this->LastCorners = this->Body.surface.corners(place.triangle);
  this->LastWeights = place.projection.weights;
  result.triangle = this->Body.surface.inputTriangle(place.triangle);
  result.contactPoint = place.projection.point;
  result.deflection = -place.signedDistance;
  const ResponseValue upright = response.evaluate(result.deflection);
  ResponseValue value = upright;
  if (this->Tilt.isTilted())
  {
    value = this->Tilt.press(this->LastCorners, this->LastWeights, result.deflection, upright,
      response.energy(result.deflection));
  }
  result.normalForce = value.force;
  result.stiffness = value.stiffness;
  result.state = value.beyondRange ? ContactState::BeyondRange : ContactState::Slide;
  if (this->IsInTime)
  {
    this->relax(place, response, value, result);
  }
  if (this->Settings.form == ForceForm::EnergyConsistent)
  {
    result.normal = place.normal;
    result.force = EnergyGradient::force(result.normalForce, place.normal,
      this->weightGradients(place), this->energies(response, result.deflection));
    return result.force.allFinite();
  }
  Vector3 direction = place.normal; // a smooth surface has one of its own
  if (!place.isSmooth)
  {
    direction = this->sumOfNormals(place, Vector3::Ones());
  }
  if (this->Settings.form == ForceForm::Paper)
  {
    const std::array<ResponseValue, 3> each = response.evaluateEach(result.deflection);
    const Vector3 sum = this->sumOfNormals(place, { each[0].force, each[1].force, each[2].force });
    const double more = upright.force > 0.0 ? result.normalForce / upright.force : 1.0;
    result.normalForce = more * sum.norm();
    direction = result.normalForce > 0.0 ? sum : direction;
  }
  const double length = direction.norm();
  result.normal = direction / length;
  result.force = result.normalForce * result.normal;
  return length > 0.0 && result.force.allFinite(); // neither of them infinite
}

void ToolContact::relax(const ContactPlace& place, const BlendedResponse& response,
  const ResponseValue& slow, Contact& result) noexcept
{
  // The material under a tilted tool has moved as under the upright one of the same force.
  ContactTilt::Alike upright;
  upright.depth = result.deflection;
  upright.value = slow;
  if (this->Tilt.isTilted())
  {
    upright = this->Tilt.alike(response);
  }
  const ContactRelaxation::Force felt = this->Relaxation.press(
    { this->LastCorners, this->LastWeights, place.projection.point, upright.depth }, upright.value);
  result.normalForce = felt.total;
  result.memory = felt.total - slow.force;
  result.stiffness = felt.stiffness * upright.stiffening;
  result.state = felt.isTouched ? result.state : ContactState::None;
}

Vector3 ToolContact::energies(const BlendedResponse& response, double deflection) const noexcept
{
  Vector3 energies = response.energies(deflection);
  if (this->Tilt.isTilted())
  {
    energies = this->Tilt.energies(this->LastCorners, energies);
  }
  if (this->IsInTime)
  {
    // What memory stores is shared out among the corners as their slow work is: curves of one tool
    // on bodies of unlike stiffness have one form.
    const double work = energies.isZero(0.0) ? 0.0 : this->work(response, deflection);
    energies *= work > 0.0 ? 1.0 + this->Relaxation.storedEnergy() / work : 1.0;
    energies += this->Relaxation.strengthEnergies();
  }
  return energies;
}

double ToolContact::cappedShare(const Contact& contact, double maximumStiffness) const noexcept
{
  const BlendedResponse response = this->response();
  double depth = contact.deflection;
  double cap = maximumStiffness;
  if (this->Tilt.isTilted() && contact.normalForce > 0.0)
  {
    const ContactTilt::Alike upright = this->Tilt.alike(response);
    depth = upright.depth;
    cap /= std::max(upright.stiffening, 1e-9);
  }
  if (!this->IsInTime)
  {
    return CappedResponse(response, cap).share(depth);
  }
  const double slowCap = cap / this->Relaxation.stiffening();
  const double whole = contact.normalForce;
  const double capped =
    this->Relaxation.cappedForce(CappedResponse(response, slowCap).evaluate(depth).force, slowCap);
  return std::min(1.0, whole > 0.0 ? capped / this->Relaxation.force() : 1.0);
}

Vector3 ToolContact::sumOfNormals(const ContactPlace& place, const Vector3& factors) const noexcept
{
  const TriangleCorners& corners = this->Body.surface.corners(place.triangle);
  Vector3 sum = Vector3::Zero();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto i = static_cast<Eigen::Index>(k);
    sum += place.projection.weights[i] * factors[i] * this->Body.response.normal(corners[k]);
  }
  return sum;
}

void ToolContact::complete(const ContactPlace& place, const BlendedResponse& response, double share,
  Contact& result) noexcept
{
  if (this->Tilt.isTilted())
  {
    this->addTorque(place, share, result);
  }
  this->addFriction(response, result);
  if (this->Tilt.isFelt() && this->Tilt.isTooFar() && result.state != ContactState::BeyondRange)
  {
    result.state = ContactState::TiltedTooFar;
  }
}

void ToolContact::addTorque(const ContactPlace& place, double share, Contact& result) const noexcept
{
  const double slow = result.normalForce - result.memory;
  const double memory = slow > 0.0 ? result.normalForce / slow : 1.0;
  const double moment = this->Tilt.moment(result.normalForce, share * memory);
  result.tilt = this->Tilt.angle();
  result.torque = this->Tilt.torque(moment);
  // Where the form promises an energy, what its tilt changes by from place to place belongs to it.
  if (this->Settings.form == ForceForm::EnergyConsistent ||
    (this->Settings.form == ForceForm::NormalizedDirection && place.isSmooth))
  {
    result.force += this->Tilt.forceBeside(
      moment, this->LastCorners, this->weightGradients(place), this->Body.response);
  }
}

void ToolContact::addFriction(const BlendedResponse& response, Contact& result) noexcept
{
  if (this->IsInTime)
  {
    result.friction = this->Relaxation.slide(result.contactPoint, result.normal);
    result.force += result.friction;
  }
  if (!(this->Settings.friction.coefficient > 0.0))
  {
    return;
  }
  const Friction::Result friction = this->Resistance.update(
    result.contactPoint, result.normal, result.normalForce, result.deflection, response);
  result.friction = this->IsInTime ? result.friction + friction.force : friction.force; // -0 stays
  result.force += friction.force;
  if (!friction.sliding && result.state == ContactState::Slide)
  {
    result.state = ContactState::Stick;
  }
}
} // namespace palpate
