// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Stiffness of one element of linear isotropic elasticity, small strains; mm, N, MPa.
 *
 * Hexahedron: trilinear with nine incompatible modes 1-ξ², 1-η², 1-ζ², condensed inside the element
 * (Wilson et al. 1973). The Jacobian is taken at the centre (Taylor, Beresford and Wilson 1976), so
 * that the element passes the patch test. The element bends without shear locking and does not lock
 * as ν → 0.5. Quadratic tetrahedron: four Gauss points, exact for straight edges. This element does
 * not lock either. Linear tetrahedron: constant strain. This element locks: it is far too stiff as
 * ν → 0.5 and in bending. It is supported for meshes without better elements.
 */
#ifndef palpate_ElasticElement_h
#define palpate_ElasticElement_h

#include "Mechanics/PalpateExport.h"
#include "Solids/FiniteElements/VolumeMesh.h"

namespace palpate
{
/// Young's modulus E (MPa) > 0 and Poisson's ratio 0 <= ν <= LargestPoissonRatio.
struct ElasticMaterial
{
  double youngsModulus = 1.0;
  double poissonRatio = 0.3;
};

/// Whether two materials are equal.
inline bool isAlike(const ElasticMaterial& a, const ElasticMaterial& b)
{
  return a.youngsModulus == b.youngsModulus && a.poissonRatio == b.poissonRatio;
}

/// Displacement elements need a compressible material.
constexpr double LargestPoissonRatio = 0.499;

using ElementNodes = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, LargestNodeCount>;
using ElementMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3 * LargestNodeCount,
  3 * LargestNodeCount>;

/// The positions of an element's nodes, 3 × n.
PALPATE_EXPORT ElementNodes elementNodes(const VolumeMesh& mesh, const VolumeElement& element);

/// Computes the stiffness, 3n × 3n, node by node (x, y, z). Returns false if the element is
/// inverted: its Jacobian is not positive at an integration point.
PALPATE_EXPORT bool elementStiffness(
  ElementKind kind, const ElementNodes& nodes, const ElasticMaterial& material, ElementMatrix& k);

/// Gradients (3 × n) of an element's shape functions, then of the three incompatible modes of a
/// hexahedron.
using ElementGradients = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 11>;

/// Computes the gradients in space at the element's own coordinates `xi` ([-1, 1]³, or the corner
/// tetrahedron of the unit cube). Returns the determinant of the Jacobian.
PALPATE_EXPORT double elementGradients(ElementKind kind, const ElementNodes& nodes,
  const Eigen::Vector3d& xi, ElementGradients& gradients);

/// The shape functions at `xi` (n × 1).
using ElementShapes = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, LargestNodeCount, 1>;
PALPATE_EXPORT ElementShapes elementShapes(ElementKind kind, const Eigen::Vector3d& xi);

/// Integration point 0 .. 3 of a quadratic tetrahedron. Its weight is 1/24 of the determinant.
PALPATE_EXPORT Eigen::Vector3d quadraticPoint(int i);

/// The corners at the ends of the edge whose middle is node 4 .. 9 of a quadratic tetrahedron.
PALPATE_EXPORT std::array<int, 2> edgeOfMiddle(int node);

/// The matrix that maps the motion of a hexahedron's nodes to the amplitudes of its modes (mode by
/// mode, three amplitudes along x, y, z), if no forces act on the modes. Forces f on the modes are
/// equivalent to forces on the nodes, the transpose of this matrix times f. The element must not be
/// inverted.
PALPATE_EXPORT Eigen::Matrix<double, 9, 24> modesOfNodes(
  const ElementNodes& nodes, const ElasticMaterial& material);

/// Volume of a hexahedron or tetrahedron from its smallest Jacobian, mm³; 0 if inverted.
PALPATE_EXPORT double leastVolume(ElementKind kind, const ElementNodes& nodes);

/// Smallest determinant of the Jacobian over the integration points; not positive if inverted.
PALPATE_EXPORT double smallestJacobian(ElementKind kind, const ElementNodes& nodes);
} // namespace palpate

#endif
