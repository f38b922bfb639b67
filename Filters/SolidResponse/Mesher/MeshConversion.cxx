// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Mesher/MeshConversion.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>

namespace palpate
{
MeshedSurface convertSurfaceToMesh(vtkPolyData* surface)
{
  MeshedSurface made;
  made.points.resize(3, surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    surface->GetPoint(i, made.points.col(i).data());
  }
  vtkNew<vtkIdList> ids;
  vtkCellArray* cells = surface->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(ids);)
  {
    made.triangles.push_back({ static_cast<std::int32_t>(ids->GetId(0)),
      static_cast<std::int32_t>(ids->GetId(1)), static_cast<std::int32_t>(ids->GetId(2)) });
  }
  return made;
}

vtkSmartPointer<vtkPolyData> convertMeshToSurface(const MeshedSurface& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.points.cols());
  for (Eigen::Index i = 0; i < mesh.points.cols(); ++i)
  {
    points->SetPoint(i, mesh.points.col(i).data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const std::array<vtkIdType, 3> corners = { a, b, c };
    triangles->InsertNextCell(3, corners.data());
  }
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

void convertTetrahedra(const CurvedTetrahedra& curved, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetNumberOfPoints(curved.nodes.cols());
  for (vtkIdType i = 0; i < curved.nodes.cols(); ++i)
  {
    points->SetPoint(i, curved.nodes.col(i).data());
  }
  vtkNew<vtkCellArray> cells;
  const auto count = static_cast<vtkIdType>(curved.cells.size());
  cells->AllocateExact(count, 10 * count);
  for (const auto& cell : curved.cells)
  {
    std::array<vtkIdType, 10> ids{};
    std::copy(cell.begin(), cell.end(), ids.begin());
    cells->InsertNextCell(10, ids.data());
  }
  output->SetPoints(points);
  output->SetCells(VTK_QUADRATIC_TETRA, cells);
}
} // namespace palpate
