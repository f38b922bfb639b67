// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Files/DataFault.h"

#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "Response/Files/TrialRun.h"

#include "vtkAbstractArray.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <map>
#include <vector>

namespace palpate
{
namespace
{
std::string attributeFault(vtkDataSetAttributes* attributes, vtkIdType count, const char* of)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(i);
    if (array && array->GetNumberOfTuples() != count)
    {
      return joined("array '", array->GetName() ? array->GetName() : "", "' has ",
        array->GetNumberOfTuples(), " values for ", count, ' ', of);
    }
  }
  return "";
}

/// Checks the offsets and the point indices of the cells.
std::string cellsFault(vtkCellArray* cells, vtkIdType points)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return "";
  }
  if (!cells->IsValid())
  {
    return "the offsets of its cells are damaged";
  }
  std::array<double, 2> ids{};
  cells->GetConnectivityArray()->GetRange(ids.data());
  const double wrong = ids[0] < 0.0 ? ids[0] : ids[1];
  return cells->GetNumberOfConnectivityIds() > 0 &&
      (wrong < 0.0 || wrong >= static_cast<double>(points))
    ? joined(
        "a cell names point ", static_cast<vtkIdType>(wrong), ", but there are ", points, " points")
    : "";
}

/// Returns the number of points of a cell of the type `type`; 0 if any number is allowed.
vtkIdType pointsOf(int type, std::map<int, vtkIdType>& known)
{
  const auto found = known.find(type);
  if (found != known.end())
  {
    return found->second;
  }
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  return known[type] = cell ? cell->GetNumberOfPoints() : -1;
}

/// Checks polyhedra and cells of higher order by a trial run of the surface filter, because their
/// valid content is defined only by their VTK classes.
std::string facesFault(vtkUnstructuredGrid* grid, double memory)
{
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(grid);
  surface->DelegationOff();
  const std::string crash = crashOf([&surface] { surface->Update(); }, memory);
  return crash.empty() ? "" : joined("the faces of its cells are damaged (", crash, ')');
}

std::string typesFault(vtkUnstructuredGrid* grid, double memory)
{
  std::map<int, vtkIdType> known;
  bool isOfFaces = false;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const int type = grid->GetCellType(i);
    const vtkIdType wanted = pointsOf(type, known);
    const vtkIdType has = grid->GetCells()->GetCellSize(i);
    if (wanted < 0)
    {
      return joined("cell ", i, " is of the unknown type ", type);
    }
    isOfFaces = isOfFaces || type >= VTK_POLYHEDRON;
    if (wanted > 0 && wanted != has)
    {
      return joined("cell ", i, " of type ", type, " has ", has, " points, not ", wanted);
    }
  }
  return isOfFaces ? facesFault(grid, memory) : "";
}

std::string structureFault(vtkDataSet* data, double memory)
{
  const vtkIdType points = data->GetNumberOfPoints();
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* cells :
      { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
    {
      std::string fault = cellsFault(cells, points);
      if (!fault.empty())
      {
        return fault;
      }
    }
    return "";
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return firstFault([&] { return cellsFault(grid->GetCells(), points); },
      [&] { return typesFault(grid, memory); });
  }
  if (auto* grid = vtkStructuredGrid::SafeDownCast(data))
  {
    const vtkIdType has = grid->GetPoints() ? grid->GetPoints()->GetNumberOfPoints() : 0;
    std::array<int, 3> size{};
    grid->GetDimensions(size.data());
    const vtkIdType wanted = static_cast<vtkIdType>(size[0]) * size[1] * size[2];
    return has == wanted ? "" : joined("it has ", has, " points, not ", wanted);
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    const std::array<vtkDataArray*, 3> axes = { grid->GetXCoordinates(), grid->GetYCoordinates(),
      grid->GetZCoordinates() };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const vtkIdType has = axes[k] ? axes[k]->GetNumberOfTuples() : 0;
      if (has != grid->GetDimensions()[k])
      {
        return joined("axis ", k, " has ", has, " coordinates, not ", grid->GetDimensions()[k]);
      }
    }
  }
  return "";
}
} // namespace

std::string dataFault(vtkDataSet* data, double memory)
{
  return firstFault([&] { return structureFault(data, memory); },
    [&] { return attributeFault(data->GetPointData(), data->GetNumberOfPoints(), "points"); },
    [&] { return attributeFault(data->GetCellData(), data->GetNumberOfCells(), "cells"); });
}
} // namespace palpate
