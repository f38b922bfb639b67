// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PreparedSurface_h
#define palpate_PreparedSurface_h

#include "Mechanics/SharedWork.h"
#include "SolidResponse/Bodies/ClosedSurface.h"
#include "SolidResponse/Mesher/CurvedTetrahedra.h"
#include "SolidResponse/Mesher/SurfaceCut.h"

#include <string>
#include <vector>

namespace palpate
{
/// A surface made ready to be filled, and sentences on what was done to it.
struct PreparedSurface
{
  ClosedSurface closed;
  MeshedSurface wanted;
  std::vector<CutPlane> cuts; ///< along which what is held was cut off
  std::vector<CutPlane> held; ///< beyond which nodes are
  std::vector<std::string> warnings;
};

/// Takes a surface, closed if it is nearly so. Returns what is wrong, or "".
std::string takeSurface(vtkPolyData* body, PreparedSurface& prepared);

/// Mends where it cuts itself, and cuts off what is held to a given depth, so that it ends there
/// and not at the next cell: the depth of such a face becomes 0 but for rounding. Where it cannot
/// be cut that is held to whole cells, of `spacing` (mm). Returns what is wrong, or "".
std::string mendAndCut(double spacing, HeldFaces& faces, PreparedSurface& prepared);

/**
 * Fills it with quadratic tetrahedra, as prepared.wanted says, their outside on the surface or on
 * `cuts`: with a deviation as small as it allows. `cells` are expected. Returns what is wrong, or
 * ""; empty where the observer stopped it.
 */
std::string fillPrepared(PreparedSurface& prepared, double spacing, double cells,
  const WorkObserver& observer, CurvedTetrahedra& curved);
} // namespace palpate

#endif
