// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ToolContact.h"

#include "Contact/BorderFade.h"
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
  this->IsReleased = false;
  this->IsWithoutEdges = false;
}

[[gnu::hot]] ContactTracker::Result ToolContact::find(const ToolPose& pose) noexcept
{
  this->IsInTime = false;
  return this->follow(pose);
}

[[gnu::hot]] ContactTracker::Result ToolContact::find(const ToolPose& pose, double elapsed) noexcept
{
  this->pass(elapsed);
  this->IsInTime = this->Relaxation.isFelt();
  return this->follow(pose);
}

[[gnu::hot]] ContactTracker::Result ToolContact::follow(const ToolPose& pose) noexcept
{
  this->prefetchLast();
  const Vector3 followed = this->Tilt.follow(pose, this->Tracker.triangle() >= 0);
  this->LastStep = followed - this->LastTip;
  this->LastTip = followed;
  this->IsNew = this->Tracker.triangle() < 0;
  const ContactTracker::Result found = this->Tracker.update(followed);
  if (this->IsWithoutEdges && found.outcome == ContactTracker::Outcome::Crease)
  {
    this->Tracker.reset();
    return this->Tracker.update(followed);
  }
  return found;
}

void ToolContact::sink(const ContactPlace& place) noexcept
{
  this->Sunk = this->Lowering;
  if (this->Tilt.isFelt())
  {
    this->Sunk += this->Tilt.turn(
      this->Body.surface.corners(place.triangle), place.projection.weights, this->Body.response);
  }
}

bool ToolContact::press(const ContactTracker::Result& found, Pressed& pressed) noexcept
{
  using Outcome = ContactTracker::Outcome;
  if (found.outcome == Outcome::Outside || found.outcome == Outcome::Invalid ||
    !this->hasResponse(found.place))
  {
    return false;
  }
  pressed.place = found.place;
  pressed.share = 1.0;
  this->Lowering = 0.0;
  this->sink(found.place);
  const BlendedResponse response(this->Body.response,
    this->Body.surface.corners(found.place.triangle), found.place.projection.weights);
  if (found.outcome == Outcome::Border)
  {
    const BorderFade left = this->fadeAt(found.place);
    pressed.depth = left.depth - this->Sunk;
    pressed.share = left.fraction;
    pressed.place.weightGradients.setZero();
  }
  else if (this->isAtEdges(found))
  {
    const EdgeEffect effect = this->edgeEffect(pressed.place);
    const double whole = response.evaluate(effect.depth).force;
    pressed.depth = effect.depth;
    pressed.share =
      effect.share + (whole > 0.0 ? response.energy(effect.depth) * effect.byDepth / whole : 0.0);
  }
  else
  {
    this->setGradients(pressed.place);
    pressed.depth = -pressed.place.signedDistance - this->Sunk;
  }
  pressed.place.weightGradients = this->weightGradients(pressed.place);
  return pressed.depth > 0.0 && pressed.share > 0.0;
}

void ToolContact::setGradients(ContactPlace& place) const noexcept
{
  if (this->Settings.form == ForceForm::EnergyConsistent &&
    this->Settings.surface == ContactSurface::Facets)
  {
    place = EnergyGradient::onFacet(this->Body.surface, this->LastTip, place);
  }
}

[[gnu::hot]] Contact ToolContact::feel(ContactTracker::Result found, double sunk) noexcept
{
  const ContactTracker::Outcome outcome = found.outcome;
  ContactPlace& place = found.place;
  this->Lowering = sunk;
  this->LastWeights.setZero();
  this->IsReleased = this->IsReleased && outcome != ContactTracker::Outcome::Outside;
  this->IsWithoutEdges = this->IsWithoutEdges && outcome != ContactTracker::Outcome::Outside;
  if (this->IsReleased && outcome != ContactTracker::Outcome::Invalid)
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
  if (this->isAtEdges(found))
  {
    return this->feelEdges(place);
  }
  if (outcome != ContactTracker::Outcome::Inside)
  {
    return this->end(stateOf(outcome));
  }
  this->setGradients(place);
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
    return this->endDetached();
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

Contact ToolContact::endDetached() noexcept
{
  this->Resistance.reset();
  this->Relaxation.lose();
  this->LastWeights.setZero();
  return withoutForce(ContactState::None);
}

BorderFade ToolContact::fadeAt(const ContactPlace& place) const noexcept
{
  return BorderFade::at(this->Body.surface, place.triangle, place.projection.weights,
    this->LastTip - place.projection.point);
}

Contact ToolContact::fade(ContactPlace& place) noexcept
{
  const BorderFade left = this->fadeAt(place);
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
    return this->endDetached();
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
  // The contact is likely to be on this triangle again or next to it. Its responses are prefetched
  // during the search.
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

void ToolContact::rehearse(double elapsed) const noexcept
{
  ToolContact scratch(*this);
  const ToolPose ahead(this->LastTip + this->LastStep);
  this->IsInTime ? scratch.update(ahead, elapsed) : scratch.update(ahead);
}

// A tick on a new triangle would wait for the triangle's memory, then for that of its new corner. A
// prefetch does not wait.
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
  // If a face is not certainly the nearest one, the tick checks the triangles around its corners.
  for (const std::int32_t corner : surface.corners(triangle))
  {
    surface.visitAround(corner, [&surface](std::int32_t near) { surface.prefetch(near); });
  }
}

[[gnu::hot]] bool ToolContact::hasResponse(const ContactPlace& place) const noexcept
{
  const TriangleCorners& corners = this->Body.surface.corners(place.triangle);
  bool valid = true;
  for (std::size_t k = 0; k < 3; ++k)
  {
    // On an edge, the opposite corners of both triangles have no effect.
    valid = valid &&
      (place.projection.weights[static_cast<Eigen::Index>(k)] == 0.0 ||
        this->Body.response.isValid(corners[k]));
  }
  return valid;
}
} // namespace palpate
