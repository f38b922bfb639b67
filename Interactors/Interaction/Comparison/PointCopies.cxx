// SPDX-License-Identifier: BSD-3-Clause
#include "PointCopies.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace palpate
{
vtkSmartPointer<vtkPolyData> copyPoint(vtkPolyData* body, vtkIdType point, vtkIdType count)
{
  auto copies = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(body->GetPoints()->GetDataType());
  copies->GetPointData()->CopyAllOn();
  copies->GetPointData()->CopyAllocate(body->GetPointData(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->InsertNextPoint(body->GetPoint(point));
    copies->GetPointData()->CopyData(body->GetPointData(), point, i);
  }
  copies->SetPoints(points);
  copies->GetFieldData()->ShallowCopy(body->GetFieldData());
  return copies;
}
} // namespace palpate
