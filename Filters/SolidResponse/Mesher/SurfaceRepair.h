// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceRepair_h
#define palpate_SurfaceRepair_h

#include "SolidResponse/Mesher/SpacingGrid.h"

#include <string>

namespace palpate
{
/**
 * Repairs a closed surface that intersects itself, as scans do at some triangles. Crossing
 * triangles are smoothed, or removed and the resulting holes closed (CGAL's Polygon Mesh
 * Processing). `mended` is set to the number of crossing pairs; if it is 0, the surface is
 * bit-identical to the given one. Returns "", or a message with the triangles if more than a
 * hundredth of them cross or the repair failed.
 *
 * Cost: 1 s per 100 thousand triangles, and 2 s more if triangles cross.
 */
std::string mendSurface(MeshedSurface& surface, std::size_t& mended);

/// Changes that closed a surface.
struct ClosedUp
{
  std::size_t points = 0; ///< points where the surface touched itself and its sheets were separated
  std::size_t holes = 0;  ///< number of filled holes
  double widest = 0.0;    ///< diagonal of the bounding box of the widest hole, mm
};

/**
 * Closes a surface that is nearly closed, such as a scan. Duplicate triangles are merged. Sheets
 * that touch each other at an edge or a point are separated by a twentieth of a side. Fragments
 * with less than a thousandth of the triangles are left out. Holes no wider than a fifth of the
 * body are filled as flat as possible (CGAL's Polygon Mesh Processing; Liepa 2003). Returns "", or
 * a message about the fault (a wider hole, no module Mesher); the surface is then unchanged. Cost:
 * 1 s per 100 thousand triangles.
 */
std::string closeSurface(MeshedSurface& surface, ClosedUp& done);
} // namespace palpate

#endif
