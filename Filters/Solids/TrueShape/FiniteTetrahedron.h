// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FiniteTetrahedron_h
#define palpate_FiniteTetrahedron_h

#include "Solids/FiniteElements/ElasticElement.h"

#include <Eigen/Core>

#include <array>

namespace palpate
{
/**
 * A tetrahedron with ten nodes at finite strain, with the neo-Hookean energy μ/2 (J^(-2/3) I₁ - 3)
 * + K/2 (J-1)² per undeformed volume, as in StrainEnergy.h for bodies of revolution. The element
 * has four Gauss points. At small strain, it is equal to the element of ElasticElement.h.
 */
class FiniteTetrahedron
{
public:
  using Vector = Eigen::Matrix<double, 30, 1>; ///< x, y, z of each node, node by node

  /// The element must not be inverted.
  explicit FiniteTetrahedron(const ElementNodes& nodes);

  /// Returns the energy under displacements of the nodes (mm), N mm. It is +inf if the element is
  /// inverted.
  double energy(const ElasticMaterial& material, const Vector& u) const;
  /// Computes the nodal forces that hold the element in the state `u`, N, and the derivative of
  /// these forces, N/mm. The element must not be inverted.
  void linearize(const ElasticMaterial& material, const Vector& u, Vector& forces,
    ElementMatrix& stiffness) const;

private:
  struct Point
  {
    Eigen::Matrix<double, 3, 10> gradients; ///< gradients of the shape functions, 1/mm
    double weight;                          ///< volume that the point represents, mm³
  };
  std::array<Point, 4> Points;
};
} // namespace palpate

#endif
