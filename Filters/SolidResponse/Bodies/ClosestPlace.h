// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ClosestPlace_h
#define palpate_ClosestPlace_h

#include "vtkType.h"

#include <Eigen/Core>

class vtkStaticCellLocator;

namespace palpate
{
/// A place of a data set and the cell that contains it.
struct ClosestPlace
{
  Eigen::Vector3d at;
  vtkIdType cell = -1;
};

/// Finds the place of the data set that is closest to `place`, which must be finite. If none is
/// found, returns the given place without a cell. Safe from any number of threads.
ClosestPlace closestPlace(vtkStaticCellLocator* locator, const Eigen::Vector3d& place);
} // namespace palpate

#endif
