// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CurvedTetrahedra_h
#define palpate_CurvedTetrahedra_h

#include "SolidResponse/Mesher/SurfaceMesher.h"

#include <functional>

namespace palpate
{
/// Quadratic tetrahedra: nodes and cells as in VTK_QUADRATIC_TETRA, the corners' nodes first.
struct CurvedTetrahedra
{
  Eigen::Matrix3Xd nodes;
  std::vector<std::array<std::int32_t, 10>> cells;
  std::size_t straightened = 0; ///< edges of the outside that stay on their chord
};

/// Moves a place to the true surface or, if the edge is sharp, to the true edge.
using EdgeReach = std::function<Eigen::Vector3d(const Eigen::Vector3d& middle, bool isSharp)>;

/**
 * Adds a node in the middle of each edge; those of the outside are moved by `reach`, unless a
 * tetrahedron's Jacobian could then fall below a tenth of that with straight edges: it is a cubic,
 * bounded by its 20 Bézier coefficients (Johnen, Remacle and Geuzaine 2013). The edges of such a
 * tetrahedron stay straight.
 */
CurvedTetrahedra curveTetrahedra(const TetrahedralMesh& mesh, const EdgeReach& reach);

/// The least Bézier coefficient of a tetrahedron's Jacobian over six times its volume with straight
/// edges: 1 where they are.
double leastJacobian(const Eigen::Matrix3Xd& nodes, const std::array<std::int32_t, 10>& cell);
} // namespace palpate

#endif
