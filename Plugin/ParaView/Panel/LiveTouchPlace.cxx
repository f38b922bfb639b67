// SPDX-License-Identifier: BSD-3-Clause
#include "LiveTouchPlace.h"

#include "Contact/ContactBody.h"

namespace palpate
{
LiveTouchPlace findPlace(const ContactBody& body, const TouchHandle& handle)
{
  LiveTouchPlace place;
  place.tip = place.surface = handle.position;
  const SurfacePoint nearest = body.tree.closest(handle.position);
  if (nearest.triangle < 0)
  {
    return place;
  }
  const TriangleCorners& corners = body.surface.corners(nearest.triangle);
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double range = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const std::int32_t corner = corners[static_cast<std::size_t>(k)];
    const double weight = nearest.projection.weights[k];
    range += weight * body.response.range(corner);
    if (body.response.isValid(corner))
    {
      normal += weight * body.response.normal(corner);
    }
  }
  place.normal = normal.norm() > 0.5 ? Eigen::Vector3d(normal.normalized())
                                     : body.surface.faceNormal(nearest.triangle);
  place.surface = nearest.projection.point;
  const double untold = handle.snaps ? 0.5 * range : 0.0;
  const double depth = handle.depth > 0.0 ? handle.depth : untold;
  place.tip = (handle.snaps ? place.surface : handle.position) - depth * place.normal;
  return place;
}
} // namespace palpate
