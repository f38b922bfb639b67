// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceMesher_h
#define palpate_SurfaceMesher_h

#include "Mechanics/SharedWork.h"
#include "SolidResponse/Mesher/SpacingGrid.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{
/// Linear tetrahedra (corners as in VTK_TETRA), and their edges on sharp edges of the surface.
struct TetrahedralMesh
{
  Eigen::Matrix3Xd nodes;
  std::vector<std::array<std::int32_t, 4>> cells;
  std::vector<std::array<std::int32_t, 2>> sharpEdges; ///< lower node first; ascending
  /// The mesh is empty because the surface is too rough: with this deviation, or with a manifold
  /// outside, it would need several times the expected number of cells.
  bool isTooRough = false;
};

/// Whether the module Mesher (MesherModule.h) can be loaded. If not, missingMesher() gives the
/// reason. The functions below and the functions of SurfaceCut.h and SurfaceRepair.h then return
/// this reason, except mendSurface, which does nothing and returns "".
bool hasSurfaceMesher();
const std::string& missingMesher();

/**
 * Delaunay refinement, then removal of slivers below 10° where possible (CGAL Mesh_3: Rineau and
 * Yvinec 2007; sharp edges: Cheng, Dey and Ramos 2007; perturbation: Tournois et al. 2009). Runs on
 * one thread; the result is bit-identical on every run. The observer receives the progress,
 * estimated from the expected number of `cells`. If it returns false, refinement ends within
 * milliseconds with an empty result. It is not called during the removal of slivers. Returns "", or
 * a message about the faults of the surface with the triangles.
 */
std::string fillSurface(
  const MeshedSurface& surface, double cells, const WorkObserver& observer, TetrahedralMesh& mesh);
} // namespace palpate

#endif
