// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactPlace_h
#define palpate_ContactPlace_h

#include "Contact/PackedMesh.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <cstdint>

namespace palpate
{
/// Where on a surface the closest point of a tip lies, and how that place moves with the tip. mm.
struct PALPATE_EXPORT ContactPlace
{
  bool isSmooth = false;             ///< on the smooth surface, or on the facets
  std::int32_t triangle = -1;        ///< of the PackedMesh
  Vector3 weights = Vector3::Zero(); ///< area coordinates: >= 0, sum 1
  Vector3 point = Vector3::Zero();   ///< in the frame of the tip
  /// Of the surface, unit, outward; at an edge or corner of facets from the tip to the point.
  Vector3 normal = Vector3::Zero();
  /// Distance from the surface to the tip: > 0 outside, < 0 inside.
  double signedDistance = 0.0;
  /// Column i: gradient of weight i as the tip moves, 1/mm; tangential.
  Eigen::Matrix3d weightGradients = Eigen::Matrix3d::Zero();

  /// On the facets. All in the mesh's local frame.
  static ContactPlace onFacet(
    const PackedMesh& mesh, const Vector3& tip, const SurfacePoint& surface) noexcept;
};
} // namespace palpate

#endif
