// SPDX-License-Identifier: BSD-3-Clause
#include "ContactTracker.h"

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
} // namespace

SurfacePoint ContactTracker::follow(
  const BodyMesh& mesh, const Vector3& tip, std::int32_t triangle) noexcept
{
  TriangleProjection best = mesh.project(tip, triangle);
  for (int step = 0; step < MaximumSteps; ++step)
  {
    const std::int32_t current = triangle;
    for (const std::int32_t corner : mesh.corners(current))
    {
      const auto around = mesh.trianglesAround(corner);
      for (const std::int32_t* other = around[0]; other != around[1]; ++other)
      {
        const TriangleProjection candidate = mesh.project(tip, *other);
        if (candidate.squaredDistance < best.squaredDistance)
        {
          best = candidate;
          triangle = *other;
        }
      }
    }
    if (triangle == current)
    {
      break;
    }
  }
  return mesh.orient(tip, triangle, best);
}

ContactTracker::Contact ContactTracker::update(const Vector3& tip) noexcept
{
  if (!tip.allFinite())
  {
    this->Triangle = -1;
    return { Outcome::Invalid, {} };
  }
  if (this->Triangle >= 0)
  {
    const SurfacePoint followed = follow(this->Mesh, tip, this->Triangle);
    const Outcome outcome = classify(followed);
    if (outcome != Outcome::Outside)
    {
      this->Triangle = outcome == Outcome::Inside ? followed.triangle : -1;
      return { outcome, followed };
    }
  }
  const SurfacePoint nearest = this->Tree.closest(tip);
  const Outcome outcome = classify(nearest);
  this->Triangle = outcome == Outcome::Inside ? nearest.triangle : -1;
  return { outcome, nearest };
}
} // namespace palpate
