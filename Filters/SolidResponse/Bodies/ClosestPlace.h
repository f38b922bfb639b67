// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ClosestPlace_h
#define palpate_ClosestPlace_h

#include "vtkType.h"

#include <Eigen/Core>

class vtkStaticCellLocator;

namespace palpate
{
/// A position in a data set, and the cell that contains it.
struct ClosestPlace
{
  Eigen::Vector3d at;
  vtkIdType cell = -1;
};

/// Returns the position in the data set that is closest to `place`. `place` must be finite. If no
/// position is found, returns `place` without a cell. Thread-safe.
ClosestPlace closestPlace(vtkStaticCellLocator* locator, const Eigen::Vector3d& place);
} // namespace palpate

#endif
