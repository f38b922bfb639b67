// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ContactTracker.h"

#include "Contact/BorderFade.h"

#include <cmath>

namespace palpate
{
namespace
{
ContactTracker::Outcome classify(const SurfacePoint& surface) noexcept
{
  if (surface.triangle < 0)
  {
    return ContactTracker::Outcome::Invalid;
  }
  if (!(surface.signedDistance < 0.0))
  {
    return ContactTracker::Outcome::Outside;
  }
  return surface.onBorder ? ContactTracker::Outcome::Border : ContactTracker::Outcome::Inside;
}

/// The nearest place so far, in its triangle.
struct Place
{
  std::int32_t triangle;
  TriangleProjection projection;
};

/// Moves across the edge the projection lies on, if that is nearer.
bool crossEdge(const PackedMesh& mesh, const Vector3& tip, Place& place) noexcept
{
  const int edge = static_cast<int>(place.projection.feature) - 3;
  const std::int32_t across = mesh.neighbour(place.triangle, edge);
  if (across < 0)
  {
    return false;
  }
  const TriangleProjection candidate = mesh.project(tip, across);
  if (!(candidate.squaredDistance < place.projection.squaredDistance))
  {
    return false;
  }
  place = { across, candidate };
  return true;
}

/// Moves to the nearest of the triangles around the corners, if it is nearer.
bool searchAround(const PackedMesh& mesh, const Vector3& tip, Place& place) noexcept
{
  const std::int32_t current = place.triangle;
  for (const std::int32_t corner : mesh.corners(current))
  {
    mesh.visitAround(corner, [&](std::int32_t other) { mesh.prefetch(other); });
  }
  for (const std::int32_t corner : mesh.corners(current))
  {
    mesh.visitAround(corner,
      [&](std::int32_t other)
      {
        if (other == current || mesh.isPlaneBeyond(tip, other, place.projection.squaredDistance))
        {
          return;
        }
        const TriangleProjection candidate = mesh.project(tip, other);
        if (candidate.squaredDistance < place.projection.squaredDistance)
        {
          place = { other, candidate };
        }
      });
  }
  return place.triangle != current;
}
} // namespace

SurfacePoint ContactTracker::follow(
  const PackedMesh& mesh, const Vector3& tip, std::int32_t triangle) noexcept
{
  Place place{ triangle, mesh.project(tip, triangle) };
  for (int step = 0; step < MaximumSteps; ++step)
  {
    const TriangleFeature feature = place.projection.feature;
    const bool onFace = feature == TriangleFeature::Face;
    const bool onEdge = !onFace && feature >= TriangleFeature::Edge0;
    if (onEdge && crossEdge(mesh, tip, place))
    {
      continue;
    }
    if (onFace && mesh.isCertainlyNearest(tip, place.triangle, place.projection))
    {
      const double depth = std::sqrt(place.projection.squaredDistance); // it is so only inside
      return { place.triangle, place.projection, -depth, false };
    }
    if (!searchAround(mesh, tip, place))
    {
      return mesh.orient(tip, place.triangle, place.projection);
    }
  }
  return {};
}

bool ContactTracker::isHeld(const Contact& contact, const Vector3& tip) const noexcept
{
  if (contact.outcome != Outcome::Border)
  {
    return contact.outcome == Outcome::Inside;
  }
  const TriangleProjection& border = contact.surface.projection;
  return BorderFade::at(this->Mesh, contact.surface.triangle, border.weights, tip - border.point)
           .share > 0.0;
}

ContactTracker::Contact ContactTracker::search(const Vector3& tip) noexcept
{
  if (!tip.allFinite())
  {
    this->Triangle = -1;
    return { Outcome::Invalid, {} };
  }
  const Vector3 local = this->Mesh.toLocal(tip);
  Contact contact;
  if (this->Triangle >= 0 && !this->Tree.isBeyondHorizon(local))
  {
    contact.surface = follow(this->Mesh, local, this->Triangle);
    contact.outcome = contact.surface.triangle < 0 ? Outcome::Outside : classify(contact.surface);
  }
  if (contact.outcome == Outcome::Outside)
  {
    contact.surface = this->Search.closestLocal(local);
    contact.outcome = classify(contact.surface);
  }
  this->Triangle = this->isHeld(contact, local) ? contact.surface.triangle : -1;
  contact.surface.projection.point += this->Mesh.centre();
  return contact;
}
} // namespace palpate
