// SPDX-License-Identifier: BSD-3-Clause
// The part of ToolContact at sharp edges (BodyEdges).
#include "Contact/ToolContact.h"

#include "Contact/EnergyGradient.h"

namespace palpate
{
EdgeEffect ToolContact::edgeEffect(ContactPlace& place) const noexcept
{
  const Vector3 tip = this->LastTip; // on facets: the followed point
  if (!place.isSmooth)
  {
    // Beyond a crease the plane of the face continues.
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
    return this->end(ContactState::None); // the tool does not reach the lowered surface
  }
  if (!(effect.depth > 0.0 && effect.share > 0.0))
  {
    if (this->IsNew)
    {
      return this->feelWithoutEdges();
    }
    this->Tracker.reset();
    this->IsReleased = true;
    return this->end(ContactState::None);
  }
  place.signedDistance = -effect.depth;
  if (place.onCrease) // beyond the edge: on the extended plane of the face
  {
    place.projection.point =
      this->LastTip + place.normal.dot(place.projection.point - this->LastTip) * place.normal;
  }
  const BlendedResponse response(
    this->Body.response, this->Body.surface.corners(place.triangle), place.projection.weights);
  Contact result;
  if (!this->hasResponse(place) || !this->blend(place, response, result))
  {
    return this->end(ContactState::Invalid);
  }
  if (result.state == ContactState::None)
  {
    return this->endDetached();
  }
  this->applyEdges(effect, response, result);
  this->keepOutward(place, result);
  this->complete(place, response, effect.share, result);
  return result;
}

Contact ToolContact::feelWithoutEdges() noexcept
{
  this->IsWithoutEdges = true;
  this->Tracker.reset();
  return this->feel(this->Tracker.update(this->LastTip), this->Lowering);
}

void ToolContact::applyEdges(
  const EdgeEffect& effect, const BlendedResponse& response, Contact& result) const noexcept
{
  const double work =
    this->work(response, effect.depth) + (this->IsInTime ? this->Relaxation.storedEnergy() : 0.0);
  const double before = result.normalForce;
  const Vector3 beside = result.force - result.normalForce * result.normal; // due to unlike curves
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
} // namespace palpate
