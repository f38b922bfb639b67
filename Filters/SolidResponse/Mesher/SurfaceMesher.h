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
/// Linear tetrahedra (corners as in VTK_TETRA), and the edges of tetrahedra that are on sharp edges
/// of the surface.
struct TetrahedralMesh
{
  Eigen::Matrix3Xd nodes;
  std::vector<std::array<std::int32_t, 4>> cells;
  std::vector<std::array<std::int32_t, 2>> sharpEdges; ///< lower node first; in ascending order
  /// Whether the mesh is empty because the surface is too rough. With the given deviation, or with
  /// a manifold outside, such a surface needs several times the expected number of cells.
  bool isTooRough = false;
};

/// Returns whether the module Mesher (MesherModule.h) can be loaded. If it cannot, missingMesher()
/// returns the reason. The functions below and the functions of SurfaceCut.h and SurfaceRepair.h
/// then return this reason as their error. Only mendSurface then does nothing and returns "".
bool hasSurfaceMesher();
const std::string& missingMesher();

/**
 * Fills a surface by Delaunay refinement, and then removes slivers below 10° where possible (CGAL
 * Mesh_3: Rineau and Yvinec 2007; sharp edges: Cheng, Dey and Ramos 2007; perturbation: Tournois et
 * al. 2009). Runs on one thread. The result is bit-identical on every run. The observer receives
 * the progress, which is estimated from the expected number of cells, `cells`. If the observer
 * returns false, the refinement ends within milliseconds with an empty result. The observer is not
 * called during the removal of slivers. Returns "", or an error message that describes the faults
 * of the surface and names the triangles.
 */
std::string fillSurface(
  const MeshedSurface& surface, double cells, const WorkObserver& observer, TetrahedralMesh& mesh);
} // namespace palpate

#endif
