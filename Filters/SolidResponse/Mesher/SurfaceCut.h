// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceCut_h
#define palpate_SurfaceCut_h

#include "SolidResponse/Mesher/SpacingGrid.h"

#include <string>

namespace palpate
{
/// A plane normal to an axis, and the side of the plane that is cut off.
struct CutPlane
{
  Eigen::Index axis = 0;
  /// If true, the part above the plane is cut off; otherwise the part below the plane.
  bool isUpper = false;
  double at = 0.0; ///< coordinate of the plane along the axis, mm
};

/**
 * Cuts off the parts of a closed surface beyond planes, and closes the surface along the planes
 * (CGAL's Polygon Mesh Processing). The surface must not intersect itself. Points on the planes
 * have exactly the coordinate of the plane. Parts smaller than `least` (mm³) are left out.
 * surface.rims is set to the edges between the cut faces and the rest of the surface. `before`
 * contains the planes of earlier cuts, whose cut faces are included. Returns "" or an error
 * message: nothing is left, the cut touches itself, or the module Mesher is missing. After an error
 * the surface is unchanged.
 *
 * Points and triangles are sorted, in the same order on every run. Cost: 1 s per 100 thousand
 * triangles.
 */
std::string cutOff(MeshedSurface& surface, const std::vector<CutPlane>& planes, double least,
  const std::vector<CutPlane>& before = {});
} // namespace palpate

#endif
