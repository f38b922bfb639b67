// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/ClosestPlace.h"

#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkStaticCellLocator.h"

namespace palpate
{
ClosestPlace closestPlace(vtkStaticCellLocator* locator, const Eigen::Vector3d& place)
{
  ClosestPlace found{ place, -1 };
  vtkNew<vtkGenericCell> cell;
  Eigen::Vector3d from = place;
  int part = 0;
  double square = 0.0;
  locator->FindClosestPoint(from.data(), found.at.data(), cell, found.cell, part, square);
  return found;
}
} // namespace palpate
