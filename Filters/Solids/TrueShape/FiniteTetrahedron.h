// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FiniteTetrahedron_h
#define palpate_FiniteTetrahedron_h

#include "Solids/FiniteElements/ElasticElement.h"

#include <Eigen/Core>

#include <array>

namespace palpate
{
/**
 * A tetrahedron of ten nodes at finite strain: Neo-Hooke's energy μ/2 (J^(-2/3) I₁ - 3) + K/2
 * (J-1)² per undeformed volume, as StrainEnergy.h has it for bodies of revolution. Four Gauss
 * points. At small strain it is that of ElasticElement.h.
 */
class FiniteTetrahedron
{
public:
  using Vector = Eigen::Matrix<double, 30, 1>; ///< of the nodes' x, y, z, node by node

  /// Must not be inverted.
  explicit FiniteTetrahedron(const ElementNodes& nodes);

  /// Stored under displacements of the nodes (mm), N mm; +inf where it is inside out.
  double energy(const ElasticMaterial& material, const Vector& u) const;
  /// The forces that hold it so, N, and their derivative, N/mm. It must not be inside out.
  void linearize(const ElasticMaterial& material, const Vector& u, Vector& forces,
    ElementMatrix& stiffness) const;

private:
  struct Point
  {
    Eigen::Matrix<double, 3, 10> gradients; ///< of the shapes, 1/mm
    double weight;                          ///< mm³
  };
  std::array<Point, 4> Points;
};
} // namespace palpate

#endif
