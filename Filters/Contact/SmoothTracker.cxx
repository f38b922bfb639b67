// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/SmoothTracker.h"

#include "Contact/BorderFade.h"

#include <algorithm>

namespace palpate
{
namespace
{
using Outcome = ContactTracker::Outcome;

Outcome classify(double signedDistance, bool onBorder) noexcept
{
  if (!(signedDistance < 0.0))
  {
    return Outcome::Outside;
  }
  return onBorder ? Outcome::Border : Outcome::Inside;
}

double longestEdge(const PackedMesh& mesh, std::int32_t triangle) noexcept
{
  const Vector3 a = mesh.corner(triangle, 0);
  const Vector3 b = mesh.corner(triangle, 1);
  const Vector3 c = mesh.corner(triangle, 2);
  return std::max({ (b - a).norm(), (c - b).norm(), (a - c).norm() });
}
} // namespace

SmoothTracker::Contact SmoothTracker::touch(
  const Vector3& tip, std::int32_t triangle, const Vector3& weights) noexcept
{
  SmoothPoint found = this->Smooth.follow(tip, triangle, weights);
  if (found.outcome == SmoothPoint::Outcome::NotFound)
  {
    const SurfacePoint facet = ContactTracker::follow(this->Mesh, tip, triangle);
    if (facet.triangle < 0)
    {
      return {}; // the tip outran it: to be searched for
    }
    if (facet.triangle != triangle)
    {
      found = this->Smooth.follow(tip, facet.triangle, facet.projection.weights);
    }
    if (found.outcome == SmoothPoint::Outcome::NotFound)
    {
      return { classify(facet.signedDistance, facet.onBorder),
        ContactPlace::onFacet(this->Mesh, tip, facet) };
    }
  }
  return { classify(found.place.signedDistance, found.outcome == SmoothPoint::Outcome::Border),
    found.place };
}

SmoothTracker::Contact SmoothTracker::search(const Vector3& tip) noexcept
{
  const SurfacePoint nearest = this->Search.closestLocal(tip);
  if (nearest.triangle < 0)
  {
    return { Outcome::Invalid, {} };
  }
  // No patch rises as high over its facet as that is long.
  if (nearest.signedDistance > longestEdge(this->Mesh, nearest.triangle))
  {
    return {};
  }
  return this->touch(tip, nearest.triangle, nearest.projection.weights);
}

SmoothTracker::Contact SmoothTracker::update(const Vector3& tip) noexcept
{
  if (!tip.allFinite())
  {
    this->reset();
    return { Outcome::Invalid, {} };
  }
  const Vector3 local = this->Mesh.toLocal(tip);
  Contact contact;
  if (this->Last.triangle >= 0 && !this->Tree.isBeyondHorizon(local))
  {
    // From where the contact should have moved with the tip, to first order.
    const Vector3 moved =
      this->Last.weights + this->Last.weightGradients.transpose() * (local - this->Tip);
    contact = this->touch(local, this->Last.triangle, moved);
  }
  if (contact.outcome == Outcome::Outside)
  {
    contact = this->search(local);
  }
  this->Last = contact.place;
  this->Tip = local;
  const bool isHeld = contact.outcome == Outcome::Inside ||
    (contact.outcome == Outcome::Border &&
      BorderFade::at(
        this->Mesh, contact.place.triangle, contact.place.weights, local - contact.place.point)
          .share > 0.0);
  if (!isHeld)
  {
    this->reset();
  }
  contact.place.point += this->Mesh.centre();
  return contact;
}
} // namespace palpate
