// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointCopy_h
#define PointCopy_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkPolyData;

namespace palpate
{
/// A body of one point, with that point's data and the body's field data, so that filters compute
/// for this point alone. No cells.
vtkSmartPointer<vtkPolyData> copyPoint(vtkPolyData* body, vtkIdType point);
} // namespace palpate

#endif
