// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointCopy_h
#define PointCopy_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkPolyData;

namespace palpate
{
/// Returns a copy of the body that consists of one point without cells. The copy has the data of
/// this point and the field data of `body`. Filters that run on the copy compute only this point.
vtkSmartPointer<vtkPolyData> copyPoint(vtkPolyData* body, vtkIdType point);
} // namespace palpate

#endif
