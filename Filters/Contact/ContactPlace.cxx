// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ContactPlace.h"

#include "Contact/EnergyGradient.h"

namespace palpate
{
ContactPlace ContactPlace::onFacet(
  const PackedMesh& mesh, const Vector3& tip, const SurfacePoint& surface) noexcept
{
  ContactPlace place;
  place.triangle = surface.triangle;
  place.weights = surface.projection.weights;
  place.point = surface.projection.point;
  place.signedDistance = surface.signedDistance;
  place.weightGradients = EnergyGradient::facetWeightGradients(surface.projection.feature,
    mesh.corner(surface.triangle, 0), mesh.corner(surface.triangle, 1),
    mesh.corner(surface.triangle, 2));
  if (surface.projection.feature == TriangleFeature::Face || surface.signedDistance == 0.0)
  {
    place.normal = mesh.faceNormal(surface.triangle);
  }
  else
  {
    place.normal = (tip - place.point) / surface.signedDistance;
  }
  return place;
}
} // namespace palpate
