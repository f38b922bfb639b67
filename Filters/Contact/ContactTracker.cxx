// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ContactTracker.h"

#include "Contact/BorderFade.h"
#include "Contact/EnergyGradient.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
ContactTracker::Outcome classify(const SurfacePoint& surface) noexcept
{
  if (!(surface.signedDistance < 0.0))
  {
    return ContactTracker::Outcome::Outside;
  }
  return surface.onCrease ? ContactTracker::Outcome::Crease
    : surface.onBorder    ? ContactTracker::Outcome::Border
                          : ContactTracker::Outcome::Inside;
}

ContactTracker::Result classified(const SurfacePoint& surface) noexcept
{
  return { classify(surface), { surface } };
}

double longestEdge(const PackedMesh& mesh, std::int32_t triangle) noexcept
{
  const Vector3 a = mesh.corner(triangle, 0);
  const Vector3 b = mesh.corner(triangle, 1);
  const Vector3 c = mesh.corner(triangle, 2);
  return std::max({ (b - a).norm(), (c - b).norm(), (a - c).norm() });
}

/// The nearest point found so far and its triangle.
struct Place
{
  std::int32_t triangle;
  TriangleProjection projection;
};

/// Moves to the neighbouring triangle across the edge on which the projection lies, if that
/// triangle is nearer. Returns whether `place` has changed.
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

/// Moves to the nearest of the triangles around the corners if it is nearer than the current
/// triangle. Returns whether `place` has changed.
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

[[gnu::hot]] SurfacePoint ContactTracker::follow(
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
      // Negative, because the tip is inside.
      const double depth = std::sqrt(place.projection.squaredDistance);
      return { place.triangle, place.projection, -depth, false };
    }
    if (!searchAround(mesh, tip, place))
    {
      return mesh.orient(tip, place.triangle, place.projection);
    }
  }
  return {};
}

std::int32_t ContactTracker::triangleAhead(const Vector3& tip) const noexcept
{
  // Corresponds to about 2 mm with triangles of 0.3 mm, more than a hand moves in one tick.
  constexpr int crossings = 16;
  const Vector3 local = this->Mesh.toLocal(tip);
  std::int32_t triangle = this->Last.triangle;
  for (int i = 0; i < crossings && triangle >= 0; ++i)
  {
    TriangleProjection unused;
    const PlaneFoot foot = this->Mesh.projectOnFace(local, triangle, unused);
    const bool isBeyond = foot != PlaneFoot::OnFace && foot != PlaneFoot::Unknown;
    const std::int32_t next =
      isBeyond ? this->Mesh.neighbour(triangle, static_cast<int>(foot)) : PackedMesh::Border;
    if (next < 0)
    {
      break;
    }
    triangle = next;
  }
  return triangle;
}

[[gnu::hot]] ContactTracker::Result ContactTracker::touch(
  const Vector3& tip, std::int32_t triangle, const Vector3& weights) noexcept
{
  SmoothPoint found = this->Smooth->follow(tip, triangle, weights);
  if (found.outcome == SmoothPoint::Outcome::NotFound)
  {
    const SurfacePoint facet = follow(this->Mesh, tip, triangle);
    if (facet.triangle < 0)
    {
      return {}; // the tip moved too far; the caller searches the whole body
    }
    if (facet.triangle != triangle)
    {
      found = this->Smooth->follow(tip, facet.triangle, facet.projection.weights);
    }
    if (found.outcome == SmoothPoint::Outcome::NotFound)
    {
      return { classify(facet), EnergyGradient::onFacet(this->Mesh, tip, facet) };
    }
  }
  return { classify(found.place), found.place };
}

[[gnu::hot]] ContactTracker::Result ContactTracker::goOn(const Vector3& tip) noexcept
{
  if (this->Smooth)
  {
    // Starts at the point to which the contact moves with the tip to first order.
    return this->touch(tip, this->Last.triangle,
      this->Last.projection.weights + this->Last.weightGradients.transpose() * (tip - this->Tip));
  }
  const SurfacePoint surface = follow(this->Mesh, tip, this->Last.triangle);
  return surface.triangle < 0 ? Result{} : classified(surface);
}

ContactTracker::Result ContactTracker::begin(const Vector3& tip) noexcept
{
  SurfacePoint nearest = this->Search.closestLocal(tip);
  if (nearest.triangle < 0)
  {
    return { Outcome::Invalid, {} };
  }
  if (nearest.onCrease && !this->Mesh.isUnderCorner(tip, nearest))
  {
    return {};
  }
  if (nearest.onCrease)
  {
    nearest.onCrease = false;
    nearest.signedDistance = -std::abs(nearest.signedDistance);
  }
  if (!this->Smooth)
  {
    return classified(nearest);
  }
  // The height of a patch above its facet never exceeds the longest edge of the facet.
  if (nearest.signedDistance > longestEdge(this->Mesh, nearest.triangle))
  {
    return {};
  }
  const Result found = this->touch(tip, nearest.triangle, nearest.projection.weights);
  return found.outcome == Outcome::Crease ? classified(nearest) : found;
}

[[gnu::hot]] bool ContactTracker::isHeld(const Result& result, const Vector3& tip) const noexcept
{
  if (result.outcome != Outcome::Border)
  {
    return result.outcome == Outcome::Inside || result.outcome == Outcome::Crease;
  }
  const TriangleProjection& border = result.place.projection;
  return BorderFade::at(this->Mesh, result.place.triangle, border.weights, tip - border.point)
           .fraction > 0.0;
}

ContactTracker::Result ContactTracker::handOver(const Vector3& tip, std::int32_t triangle) noexcept
{
  const ContactPlace before = this->Last;
  const Vector3 local = this->Mesh.toLocal(tip);
  this->Last = {};
  this->Last.triangle = triangle;
  this->Last.projection.weights.setConstant(1.0 / 3.0);
  Result result = this->goOn(local);
  this->Last = result.outcome == Outcome::Inside ? result.place : before;
  result.place.projection.point += this->Mesh.centre();
  return result;
}

[[gnu::hot]] ContactTracker::Result ContactTracker::search(const Vector3& tip) noexcept
{
  if (!tip.allFinite())
  {
    this->reset();
    return { Outcome::Invalid, {} };
  }
  const Vector3 local = this->Mesh.toLocal(tip);
  Result result;
  if (this->Last.triangle >= 0 && !this->Tree.isBeyondHorizon(local))
  {
    result = this->goOn(local);
  }
  if (result.outcome == Outcome::Outside)
  {
    result = this->begin(local);
  }
  this->Last = result.place;
  this->Tip = local;
  if (!this->isHeld(result, local))
  {
    this->reset();
  }
  result.place.projection.point += this->Mesh.centre();
  return result;
}
} // namespace palpate
