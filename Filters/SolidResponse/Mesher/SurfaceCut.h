// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceCut_h
#define palpate_SurfaceCut_h

#include "SolidResponse/Mesher/SpacingGrid.h"

#include <string>

namespace palpate
{
/// A plane across an axis, and which side of it is cut off.
struct CutPlane
{
  Eigen::Index axis = 0;
  bool isUpper = false; ///< what lies above it goes, else what lies below
  double at = 0.0;      ///< mm
};

/**
 * Cuts off what lies beyond planes of a closed surface that does not intersect itself, and closes
 * it along them (CGAL's Polygon Mesh Processing): points there lie on the plane to the bit. Parts
 * smaller than `least` (mm³) are left out. `rims` become the edges between the planes and the rest,
 * and those of `before`, along which the surface was cut before.
 * Returns what is wrong - nothing is left, the cut touches itself, no module Mesher - and
 * leaves the surface unchanged, or "".
 *
 * Points and triangles are in an order of their own, the same on every run. Cost: 1 s per 100
 * thousand triangles.
 */
std::string cutOff(MeshedSurface& surface, const std::vector<CutPlane>& planes, double least,
  const std::vector<CutPlane>& before = {});
} // namespace palpate

#endif
