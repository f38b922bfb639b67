// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilledCells_h
#define FilledCells_h

#include "SolidResponse/Bodies/CellPlaces.h"

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkCell;
class vtkUnstructuredGrid;

namespace palpate
{
/// A ball in a body, mm.
struct BodyBall
{
  std::array<double, 3> middle{};
  double radius = 0.0;
};

/// Computes the fraction of a cell's volume that each of several balls fills. The fractions are
/// counted at n³ points of the cell (CellPlaces). A point that is in several balls belongs to the
/// last of them.
class FilledCells
{
public:
  FilledCells(std::vector<BodyBall> balls, int subdivisions);

  /// Returns the fractions in the cell `id`, one per ball. Returns null if no ball intersects the
  /// cell.
  const std::vector<double>* fractions(vtkUnstructuredGrid* grid, vtkIdType id);

private:
  /// Finds the indices of the balls that intersect a box.
  void findNear(const double* bounds);
  bool hasWithin(const double* bounds, std::size_t ball) const;
  void count(vtkCell* cell);

  std::vector<BodyBall> Balls;
  CellPlaces Places;
  std::vector<std::size_t> Near;
  std::vector<double> Fractions;
};
} // namespace palpate

#endif
