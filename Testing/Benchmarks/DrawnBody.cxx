// SPDX-License-Identifier: BSD-3-Clause
#include "DrawnBody.h"

#include "BumpySphere.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace palpate::benchmarks
{
vtkSmartPointer<vtkPolyData> drawnBody(double triangles)
{
  const testing::Surface surface = testing::bumpySphere(testing::bumpyCuts(triangles));
  vtkNew<vtkPoints> points;
  for (const Vector3& point : surface.points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (const Vector3& normal : testing::bumpyNormals(surface))
  {
    normals->InsertNextTuple(normal.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : surface.triangles)
  {
    cells->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  auto body = vtkSmartPointer<vtkPolyData>::New();
  body->SetPoints(points);
  body->SetPolys(cells);
  body->GetPointData()->SetNormals(normals);
  return body;
}
} // namespace palpate::benchmarks
