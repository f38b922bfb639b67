// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/CellPlaces.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkHexahedron.h"
#include "vtkPoints.h"

#include <Eigen/Dense>

#include <cmath>

namespace palpate
{
namespace
{
bool isTetrahedron(vtkCell* cell)
{
  return cell->GetCellType() == VTK_TETRA || cell->GetCellType() == VTK_QUADRATIC_TETRA;
}

/// Returns the determinant of a hexahedron's Jacobian.
double volumeAt(vtkCell* cell, const std::array<double, 3>& at)
{
  std::array<double, 24> slopes{};
  vtkHexahedron::InterpolationDerivs(at.data(), slopes.data());
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 8; ++i)
  {
    Eigen::Vector3d corner;
    cell->GetPoints()->GetPoint(i, corner.data());
    for (int k = 0; k < 3; ++k)
    {
      jacobian.col(k) += slopes[static_cast<std::size_t>(8 * k + i)] * corner;
    }
  }
  return std::abs(jacobian.determinant());
}

} // namespace

void CellPlaces::visit(
  vtkCell* cell, const std::function<void(const std::array<double, 3>& place, double volume)>& to)
{
  const bool halves = isTetrahedron(cell);
  const bool isHexahedron = cell->GetCellType() == VTK_HEXAHEDRON;
  const int n = this->Along;
  this->Weights.resize(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  for (int place = 0; place < n * n * n; ++place)
  {
    const std::array<double, 3> at = { (place % n + 0.5) / n, (place / n % n + 0.5) / n,
      (place / (n * n) + 0.5) / n };
    if (halves && at[0] + at[1] + at[2] > 1.0 + 1e-9)
    {
      continue;
    }
    std::array<double, 3> x{};
    int part = 0;
    cell->EvaluateLocation(part, at.data(), x.data(), this->Weights.data());
    to(x, isHexahedron ? volumeAt(cell, at) : 1.0);
  }
}
} // namespace palpate
