// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointCopy_h
#define PointCopy_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkPolyData;

namespace palpate
{
/// Returns a body with one point, the data of this point, and the field data of `body`. Filters
/// then compute only this point. The result has no cells.
vtkSmartPointer<vtkPolyData> copyPoint(vtkPolyData* body, vtkIdType point);
} // namespace palpate

#endif
