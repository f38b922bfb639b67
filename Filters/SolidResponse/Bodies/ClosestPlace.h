// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ClosestPlace_h
#define palpate_ClosestPlace_h

#include "vtkType.h"

#include <Eigen/Core>

class vtkStaticCellLocator;

namespace palpate
{
/// A place of a data set, and the cell it lies in.
struct ClosestPlace
{
  Eigen::Vector3d at;
  vtkIdType cell = -1;
};

/// The closest one to a finite place; where there is none, that itself and no cell. From any number
/// of threads.
ClosestPlace closestPlace(vtkStaticCellLocator* locator, const Eigen::Vector3d& place);
} // namespace palpate

#endif
