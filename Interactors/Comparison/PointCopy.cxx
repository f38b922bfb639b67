// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/PointCopy.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace palpate
{
vtkSmartPointer<vtkPolyData> copyPoint(vtkPolyData* body, vtkIdType point)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(body->GetPoints()->GetDataType());
  copy->GetPointData()->CopyAllOn();
  copy->GetPointData()->CopyAllocate(body->GetPointData(), 1);
  points->InsertNextPoint(body->GetPoint(point));
  copy->GetPointData()->CopyData(body->GetPointData(), point, 0);
  copy->SetPoints(points);
  copy->GetFieldData()->ShallowCopy(body->GetFieldData());
  return copy;
}
} // namespace palpate
