// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FiniteTetrahedron_h
#define palpate_FiniteTetrahedron_h

#include "Solids/FiniteElements/ElasticElement.h"

#include <Eigen/Core>

#include <array>

namespace palpate
{
/**
 * A tetrahedron of ten nodes at finite strain, with the Neo-Hookean energy μ/2 (J^(-2/3) I₁ - 3) +
 * K/2 (J-1)² per undeformed volume, as in StrainEnergy.h for bodies of revolution. It has four
 * Gauss points. At small strain it is equal to the element of ElasticElement.h.
 */
class FiniteTetrahedron
{
public:
  using Vector = Eigen::Matrix<double, 30, 1>; ///< x, y, z of the nodes, node by node

  /// The element must not be inverted.
  explicit FiniteTetrahedron(const ElementNodes& nodes);

  /// Energy under displacements of the nodes (mm), N mm; +inf if the element is inverted.
  double energy(const ElasticMaterial& material, const Vector& u) const;
  /// Nodal forces that hold the element in this state, N, and their derivative, N/mm. The element
  /// must not be inverted.
  void linearize(const ElasticMaterial& material, const Vector& u, Vector& forces,
    ElementMatrix& stiffness) const;

private:
  struct Point
  {
    Eigen::Matrix<double, 3, 10> gradients; ///< gradients of the shape functions, 1/mm
    double weight;                          ///< mm³
  };
  std::array<Point, 4> Points;
};
} // namespace palpate

#endif
