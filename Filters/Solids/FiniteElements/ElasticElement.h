// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Stiffness of one finite element with linear isotropic elasticity at small strain, in mm, N and
 * MPa.
 *
 * Hexahedron: trilinear shape functions with nine incompatible modes, 1-ξ², 1-η², 1-ζ² in three
 * directions, which are condensed inside the element (Wilson et al. 1973). The Jacobian of the
 * modes is taken at the centre (Taylor, Beresford and Wilson 1976), so that the element passes the
 * patch test. The element bends without shear locking and does not lock as ν → 0.5. Quadratic
 * tetrahedron: integration with four Gauss points, which is exact for straight edges. This element
 * does not lock either. Linear tetrahedron: constant strain. This element locks; it is far too
 * stiff as ν → 0.5 and in bending. It is supported for meshes without better elements.
 */
#ifndef palpate_ElasticElement_h
#define palpate_ElasticElement_h

#include "Mechanics/PalpateExport.h"
#include "Solids/FiniteElements/VolumeMesh.h"

namespace palpate
{
/// Material of an element. Young's modulus E (MPa) is > 0, and Poisson's ratio ν is from 0 to
/// LargestPoissonRatio.
struct ElasticMaterial
{
  double youngsModulus = 1.0;
  double poissonRatio = 0.3;
};

/// Returns whether two materials are equal.
inline bool isAlike(const ElasticMaterial& a, const ElasticMaterial& b)
{
  return a.youngsModulus == b.youngsModulus && a.poissonRatio == b.poissonRatio;
}

/// Largest Poisson's ratio, because displacement elements need a compressible material.
constexpr double LargestPoissonRatio = 0.499;

using ElementNodes = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, LargestNodeCount>;
using ElementMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3 * LargestNodeCount,
  3 * LargestNodeCount>;

/// Returns the positions of an element's nodes, 3 × n.
PALPATE_EXPORT ElementNodes elementNodes(const VolumeMesh& mesh, const VolumeElement& element);

/// Computes the stiffness, 3n × 3n, ordered node by node (x, y, z). Returns false if the element is
/// inverted, which means that its Jacobian is not positive at an integration point.
PALPATE_EXPORT bool elementStiffness(
  ElementKind kind, const ElementNodes& nodes, const ElasticMaterial& material, ElementMatrix& k);

/// Gradients (3 × n) of an element's shape functions, followed by those of the three incompatible
/// modes of a hexahedron.
using ElementGradients = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 11>;

/// Computes the gradients in space at `xi`, the element's own coordinates. These are in [-1, 1]³
/// for a hexahedron, and in the corner tetrahedron of the unit cube for a tetrahedron. Returns the
/// determinant of the Jacobian.
PALPATE_EXPORT double elementGradients(ElementKind kind, const ElementNodes& nodes,
  const Eigen::Vector3d& xi, ElementGradients& gradients);

/// The values of the shape functions of an element, n × 1.
using ElementShapes = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, LargestNodeCount, 1>;
PALPATE_EXPORT ElementShapes elementShapes(ElementKind kind, const Eigen::Vector3d& xi);

/// Returns the integration point 0 to 3 of a quadratic tetrahedron. Its weight is 1/24 of the
/// determinant.
PALPATE_EXPORT Eigen::Vector3d quadraticPoint(int i);

/// Returns the corners at the ends of the edge whose mid-edge node is 4 to 9 of a quadratic
/// tetrahedron.
PALPATE_EXPORT std::array<int, 2> edgeOfMiddle(int node);

/// Returns the matrix that maps the motion of a hexahedron's nodes to the amplitudes of its
/// incompatible modes, if no forces act on the modes. The amplitudes are ordered mode by mode, with
/// three amplitudes along x, y, z. Forces f on the modes are equivalent to the transpose of this
/// matrix times f on the nodes. The element must not be inverted.
PALPATE_EXPORT Eigen::Matrix<double, 9, 24> modesOfNodes(
  const ElementNodes& nodes, const ElasticMaterial& material);

/// Returns the volume of a hexahedron or tetrahedron computed with its smallest Jacobian, mm³; 0 if
/// the element is inverted.
PALPATE_EXPORT double leastVolume(ElementKind kind, const ElementNodes& nodes);

/// Returns the smallest determinant of the Jacobian over the integration points. It is not positive
/// if the element is inverted.
PALPATE_EXPORT double smallestJacobian(ElementKind kind, const ElementNodes& nodes);
} // namespace palpate

#endif
