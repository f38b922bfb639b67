// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceRepair_h
#define palpate_SurfaceRepair_h

#include "SolidResponse/Mesher/SpacingGrid.h"

#include <string>

namespace palpate
{
/**
 * Repairs a closed surface that intersects itself, as scans do at some triangles: those that cross
 * are smoothed or removed, and the hole is closed again (CGAL's Polygon Mesh Processing). `mended`
 * becomes the number of crossing pairs; if it is 0 the surface is unchanged, to the bit. Returns
 * what is wrong, by its triangles: more than a hundredth of them cross, or the repair failed; or
 * "".
 *
 * Cost: 1 s per 100 thousand triangles, 2 s more where some cross.
 */
std::string mendSurface(MeshedSurface& surface, std::size_t& mended);

/// What was done to a surface so that it is closed.
struct ClosedUp
{
  std::size_t points = 0; ///< where it touched itself and its sheets were separated
  std::size_t holes = 0;  ///< that were filled
  double widest = 0.0;    ///< of them, the diagonal of its box, mm
};

/**
 * Closes a surface that is nearly so, as scans are: duplicate triangles are merged, sheets that
 * touch each other at an edge or a point are separated by a twentieth of a side, fragments of less
 * than a thousandth of the triangles are left out, holes no wider than a fifth of the body are
 * filled as flat as possible (CGAL's Polygon Mesh Processing; Liepa 2003). Returns what is wrong -
 * a wider hole, no module Mesher - and leaves the surface unchanged, or "". Cost: 1 s per
 * 100 thousand triangles.
 */
std::string closeSurface(MeshedSurface& surface, ClosedUp& done);
} // namespace palpate

#endif
