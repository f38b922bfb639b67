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
 * Places spread over a cell, n along each side, each with the volume around it, relative:
 * hexahedra and voxels as they are, tetrahedra, also quadratic ones, with straight sides.
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
  std::vector<double> Weights; ///< of a cell's points
};
} // namespace palpate

#endif
