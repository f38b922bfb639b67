// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CurvedTetrahedra_h
#define palpate_CurvedTetrahedra_h

#include "SolidResponse/Mesher/SurfaceMesher.h"

#include <functional>

namespace palpate
{
/// Quadratic tetrahedra. Nodes and cells are ordered as in VTK_QUADRATIC_TETRA, with the corner
/// nodes first.
struct CurvedTetrahedra
{
  Eigen::Matrix3Xd nodes;
  std::vector<std::array<std::int32_t, 10>> cells;
  std::size_t straightened = 0; ///< number of outer edges that are left straight
};

/// Returns the point of the true surface to which a mid-edge node is moved. For a sharp edge, it is
/// a point on the true edge.
using EdgeReach = std::function<Eigen::Vector3d(const Eigen::Vector3d& middle, bool isSharp)>;

/**
 * Adds a node in the middle of each edge. Nodes on outer edges are moved by `reach`. The edges of a
 * tetrahedron are left straight if its Jacobian could fall below a tenth of the Jacobian with
 * straight edges. The Jacobian is a cubic and is bounded by its 20 Bézier coefficients (Johnen,
 * Remacle and Geuzaine 2013).
 */
CurvedTetrahedra curveTetrahedra(const TetrahedralMesh& mesh, const EdgeReach& reach);

/// Returns the smallest Bézier coefficient of a tetrahedron's Jacobian, divided by six times its
/// volume with straight edges. It is 1 if the edges are straight.
double leastJacobian(const Eigen::Matrix3Xd& nodes, const std::array<std::int32_t, 10>& cell);
} // namespace palpate

#endif
