// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellPlaces_h
#define CellPlaces_h

#include <array>
#include <functional>
#include <vector>

class vtkCell;

namespace palpate
{
/**
 * Sample points in a cell, with n points along each side. Each point has a weight, the fraction of
 * the volume that it represents. The sides of tetrahedra, including quadratic tetrahedra, are taken
 * as straight.
 */
class CellPlaces
{
public:
  explicit CellPlaces(int n)
    : Along(n)
  {
  }

  void visit(vtkCell* cell,
    const std::function<void(const std::array<double, 3>& place, double volume)>& to);

private:
  int Along;
  std::vector<double> Weights; ///< weights of the sample points of a cell
};
} // namespace palpate

#endif
