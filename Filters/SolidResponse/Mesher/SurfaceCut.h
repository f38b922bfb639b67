// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceCut_h
#define palpate_SurfaceCut_h

#include "SolidResponse/Mesher/SpacingGrid.h"

#include <string>

namespace palpate
{
/// A plane normal to an axis, and the side of it that is cut off.
struct CutPlane
{
  Eigen::Index axis = 0;
  bool isUpper = false; ///< true: the part above the plane is cut off, else the part below
  double at = 0.0;      ///< coordinate of the plane along the axis, mm
};

/**
 * Cuts off the parts beyond planes of a closed surface that does not intersect itself, and closes
 * it along the planes (CGAL's Polygon Mesh Processing). Points on the planes have exactly the
 * coordinate of the plane. Parts smaller than `least` (mm³) are left out. surface.rims is set to
 * the edges between the cut faces and the rest of the surface, including the cut faces of `before`,
 * the planes of earlier cuts. Returns "", or a message about the fault (nothing is left, the cut
 * touches itself, no module Mesher); the surface is then unchanged.
 *
 * Points and triangles are sorted, in the same order on every run. Cost: 1 s per 100 thousand
 * triangles.
 */
std::string cutOff(MeshedSurface& surface, const std::vector<CutPlane>& planes, double least,
  const std::vector<CutPlane>& before = {});
} // namespace palpate

#endif
