// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/EnergyGradient.h"

#include <Eigen/Geometry>

namespace palpate
{
Eigen::Matrix3d EnergyGradient::facetWeightGradients(
  TriangleFeature feature, const Vector3& a, const Vector3& b, const Vector3& c) noexcept
{
  Eigen::Matrix3d gradients = Eigen::Matrix3d::Zero();
  const auto alongEdge = [&](int from, int to, const Vector3& edge)
  {
    gradients.col(to) = edge / edge.squaredNorm();
    gradients.col(from) = -gradients.col(to);
  };
  switch (feature)
  {
    case TriangleFeature::Face:
    {
      const Vector3 normal = (b - a).cross(c - a);
      const Vector3 scaled = normal / normal.squaredNorm();
      gradients.col(0) = scaled.cross(c - b);
      gradients.col(1) = scaled.cross(a - c);
      gradients.col(2) = scaled.cross(b - a);
      break;
    }
    case TriangleFeature::Edge0:
      alongEdge(0, 1, b - a);
      break;
    case TriangleFeature::Edge1:
      alongEdge(1, 2, c - b);
      break;
    case TriangleFeature::Edge2:
      alongEdge(2, 0, a - c);
      break;
    default:
      break;
  }
  return gradients;
}

ContactPlace EnergyGradient::onFacet(
  const PackedMesh& mesh, const Vector3& tip, const SurfacePoint& surface) noexcept
{
  ContactPlace place{ surface };
  place.weightGradients =
    facetWeightGradients(surface.projection.feature, mesh.corner(surface.triangle, 0),
      mesh.corner(surface.triangle, 1), mesh.corner(surface.triangle, 2));
  if (surface.projection.feature == TriangleFeature::Face || surface.signedDistance == 0.0)
  {
    place.normal = mesh.faceNormal(surface.triangle);
  }
  else
  {
    place.normal = (tip - surface.projection.point) / surface.signedDistance;
  }
  return place;
}
} // namespace palpate
