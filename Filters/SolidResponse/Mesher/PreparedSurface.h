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
/// A surface that is ready to be filled, and warnings about the changes to the surface.
struct PreparedSurface
{
  ClosedSurface closed;
  MeshedSurface wanted;
  std::vector<CutPlane> cuts; ///< planes at which the held part was cut off
  std::vector<CutPlane> held; ///< planes beyond which nodes are held
  std::vector<std::string> warnings;
};

/// Copies a surface, and closes it if it is nearly closed. Returns "" or an error message.
std::string takeSurface(vtkPolyData* body, PreparedSurface& prepared);

/// Mends the surface where it intersects itself, and cuts off the part that is held within a given
/// depth. The body then ends exactly at this depth and not at the next cell, and the depth in
/// `faces` is set to nearly 0. If the surface cannot be cut, whole cells are held instead, and a
/// warning is added. `spacing` is the length of the cells, mm. Returns "" or an error message.
std::string mendAndCut(double spacing, HeldFaces& faces, PreparedSurface& prepared);

/**
 * Fills the surface with quadratic tetrahedra. prepared.wanted defines the sizes of the tetrahedra.
 * Their outer faces are on the surface or on prepared.cuts. If the surface is too rough for the
 * deviation, the deviation is increased. `cells` is the expected number of cells. Returns "" or an
 * error message. `curved` is empty if the observer stopped the work.
 */
std::string fillPrepared(PreparedSurface& prepared, double spacing, double cells,
  const WorkObserver& observer, CurvedTetrahedra& curved);
} // namespace palpate

#endif
