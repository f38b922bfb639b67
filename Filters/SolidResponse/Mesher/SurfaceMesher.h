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
/// Linear tetrahedra (corners as in VTK_TETRA), and edges of them on sharp edges of the surface.
struct TetrahedralMesh
{
  Eigen::Matrix3Xd nodes;
  std::vector<std::array<std::int32_t, 4>> cells;
  std::vector<std::array<std::int32_t, 2>> sharpEdges; ///< the lower node first, ascending
  /// The mesh is empty, as the surface is so rough that the deviation, or an outside that is a
  /// manifold, would need several times the cells expected.
  bool isTooRough = false;
};

/// Whether the module Mesher (MesherModule.h) can be loaded. Otherwise missingMesher() says why
/// not, and the functions below, of SurfaceCut.h and of SurfaceRepair.h return that; mendSurface
/// alone then does nothing.
bool hasSurfaceMesher();
const std::string& missingMesher();

/**
 * Delaunay refinement, then removal of slivers below 10° as far as possible (CGAL Mesh_3: Rineau
 * and Yvinec 2007; sharp edges: Cheng, Dey and Ramos 2007; perturbation: Tournois et al. 2009). On
 * one thread; the same bits on every run. The observer is told the estimated progress, `cells`
 * being expected; if it returns false, refinement ends within milliseconds with an empty result. It
 * is not called while slivers are moved. Returns what is wrong with the surface, by its triangles,
 * or "".
 */
std::string fillSurface(
  const MeshedSurface& surface, double cells, const WorkObserver& observer, TetrahedralMesh& mesh);
} // namespace palpate

#endif
