// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceRepair_h
#define palpate_SurfaceRepair_h

#include "SolidResponse/Mesher/SpacingGrid.h"

#include <string>

namespace palpate
{
/**
 * Repairs a closed surface that intersects itself, as many scans do at some triangles. Crossing
 * triangles are smoothed, or they are removed and the resulting holes are closed (CGAL's Polygon
 * Mesh Processing). `mended` is set to the number of crossing pairs. If it is 0, the surface is
 * unchanged. Returns "", or an error message that names triangles if more than a hundredth of the
 * triangles cross or the repair failed.
 *
 * Cost: 1 s per 100 thousand triangles, and 2 s more if triangles cross.
 */
std::string mendSurface(MeshedSurface& surface, std::size_t& mended);

/// Changes that closed a surface.
struct ClosedUp
{
  std::size_t points = 0; ///< points at which the surface touched itself and was separated
  std::size_t holes = 0;  ///< number of filled holes
  double widest = 0.0;    ///< diagonal of the bounding box of the widest hole, mm
};

/**
 * Closes a surface that is nearly closed, such as a scan. Duplicate triangles are merged. Sheets
 * that touch each other at an edge or a point are separated by a twentieth of a side. Fragments
 * with less than a thousandth of the triangles are left out. Holes no wider than a fifth of the
 * body are filled as flat as possible (CGAL's Polygon Mesh Processing; Liepa 2003). Returns "" or
 * an error message: a hole is wider, or the module Mesher is missing. After an error the surface is
 * unchanged. Cost: 1 s per 100 thousand triangles.
 */
std::string closeSurface(MeshedSurface& surface, ClosedUp& done);
} // namespace palpate

#endif
