// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_VolumeBlock_h
#define palpate_testing_VolumeBlock_h

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <functional>
#include <utility>

namespace palpate::testing
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// A block of side × side × height cells of 1 mm on a fixed base, as voxels or hexahedra.
inline Grid block(int side, int height, int cellType = VTK_VOXEL)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> fixed;
  fixed->SetName("Fixed");
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  for (int k = 0; k <= height; ++k)
  {
    for (int j = 0; j <= side; ++j)
    {
      for (int i = 0; i <= side; ++i)
      {
        points->InsertNextPoint(i, j, k);
        fixed->InsertNextValue(k == 0 ? 7 : 0);
        heights->InsertNextValue(k);
      }
    }
  }
  auto grid = Grid::New();
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(fixed);
  grid->GetPointData()->AddArray(heights);
  const auto id = [side](int i, int j, int k) -> vtkIdType
  { return (k * (side + 1) + j) * (side + 1) + i; };
  for (int k = 0; k < height; ++k)
  {
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        std::array<vtkIdType, 8> corners = { id(i, j, k), id(i + 1, j, k), id(i, j + 1, k),
          id(i + 1, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1), id(i, j + 1, k + 1),
          id(i + 1, j + 1, k + 1) };
        if (cellType == VTK_HEXAHEDRON)
        {
          std::swap(corners[2], corners[3]);
          std::swap(corners[6], corners[7]);
        }
        grid->InsertNextCell(cellType, 8, corners.data());
      }
    }
  }
  return grid;
}

/// A block of x × y × z voxels of 1 mm. A point is held if `isFixed(i, j)` is true for its indices
/// along x and y.
inline Grid voxels(int x, int y, int z, const std::function<bool(int, int)>& isFixed)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> fixed;
  fixed->SetName("Fixed");
  for (int k = 0; k <= z; ++k)
  {
    for (int j = 0; j <= y; ++j)
    {
      for (int i = 0; i <= x; ++i)
      {
        points->InsertNextPoint(i, j, k);
        fixed->InsertNextValue(isFixed(i, j) ? 7 : 0);
      }
    }
  }
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(fixed);
  const auto id = [&](int i, int j, int k) -> vtkIdType { return (k * (y + 1) + j) * (x + 1) + i; };
  for (int k = 0; k < z; ++k)
  {
    for (int j = 0; j < y; ++j)
    {
      for (int i = 0; i < x; ++i)
      {
        const std::array<vtkIdType, 8> corners = { id(i, j, k), id(i + 1, j, k), id(i, j + 1, k),
          id(i + 1, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1), id(i, j + 1, k + 1),
          id(i + 1, j + 1, k + 1) };
        grid->InsertNextCell(VTK_VOXEL, 8, corners.data());
      }
    }
  }
  return grid;
}

inline void addCells(vtkUnstructuredGrid* grid, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(grid->GetNumberOfCells());
  array->Fill(value);
  grid->GetCellData()->AddArray(array);
}
} // namespace palpate::testing

#endif
