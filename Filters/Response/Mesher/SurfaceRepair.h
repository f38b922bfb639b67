// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceRepair_h
#define palpate_SurfaceRepair_h

#include "Response/Mesher/SpacingGrid.h"

#include <string>

namespace palpate
{
/**
 * Mends a closed surface where it cuts itself, as scans do at some triangles: those that cross are
 * smoothed or taken out, and the hole is closed again (CGAL's Polygon Mesh Processing). `mended`
 * becomes how many pairs crossed; 0 leaves the surface as it was, to the bit. Returns what is
 * wrong, by its triangles: more than a hundredth of them cross, or it could not be mended; or "".
 *
 * Cost: 1 s per 100 thousand triangles, 2 s more where some cross.
 */
std::string mendSurface(MeshedSurface& surface, std::size_t& mended);
} // namespace palpate

#endif
