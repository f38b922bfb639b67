// SPDX-License-Identifier: BSD-3-Clause
#ifndef RigidFrame_h
#define RigidFrame_h

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// Returns a frame whose origin is at `origin`. The axis with the index `axis` (0 = x, 2 = z)
/// points along `direction`, which must not be zero. The rotation about this axis is arbitrary.
inline vtkSmartPointer<vtkMatrix4x4> frameAlong(
  const double origin[3], const double direction[3], int axis)
{
  double along[3] = { direction[0], direction[1], direction[2] };
  vtkMath::Normalize(along);
  double side[3];
  double other[3];
  vtkMath::Perpendiculars(along, side, other, 0.0);
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 3; ++row)
  {
    matrix->SetElement(row, axis, along[row]);
    matrix->SetElement(row, (axis + 1) % 3, side[row]);
    matrix->SetElement(row, (axis + 2) % 3, other[row]);
    matrix->SetElement(row, 3, origin[row]);
  }
  return matrix;
}
} // namespace palpate

#endif
