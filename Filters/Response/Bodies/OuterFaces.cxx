// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/OuterFaces.h"

#include "Mechanics/JoinedText.h"

#include "vtkCell.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkExtractCells.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRectilinearGrid.h"
#include "vtkStaticCleanPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkTrivialProducer.h"
#include "vtkUnstructuredGrid.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string_view>
#include <utility>

namespace palpate
{
namespace
{
using Eigen::Vector3d;

/// Points closer than this fraction of the diagonal are merged.
constexpr double RoundedApart = 1e-6;

bool isStructured(vtkDataSet* data)
{
  return vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data) ||
    vtkStructuredGrid::SafeDownCast(data);
}

Vector3d placeOf(vtkPoints* points, vtkIdType id)
{
  Vector3d place;
  points->GetPoint(id, place.data());
  return place;
}

/// Returns six times the volume that the faces of a cell enclose. Each face is divided into a fan
/// of triangles. The volume is negative if the cell winds inward.
double sixfoldVolume(vtkCell* cell)
{
  const Vector3d origin = placeOf(cell->GetPoints(), 0);
  double sum = 0.0;
  for (int i = 0; i < cell->GetNumberOfFaces(); ++i)
  {
    vtkCell* face = cell->GetFace(i);
    // A face has as many edges as corners. The mid-edge nodes follow the corners.
    const int corners = face->GetNumberOfEdges();
    const bool isPixel = face->GetCellType() == VTK_PIXEL;
    const auto corner = [&](int k) -> Vector3d // corners in order around the face
    { return placeOf(face->GetPoints(), isPixel && k > 1 ? 5 - k : k) - origin; };
    for (int k = 1; k + 1 < corners; ++k)
    {
      sum += corner(0).dot(corner(k).cross(corner(k + 1)));
    }
  }
  return sum;
}

std::vector<vtkIdType> pointsOf(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  grid->GetCellPoints(cell, count, points);
  std::vector<vtkIdType> sorted(points, points + count);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

/// Finds cells that have the same type and the same points as an earlier cell.
std::vector<bool> findRepeated(vtkUnstructuredGrid* grid)
{
  const vtkIdType count = grid->GetNumberOfCells();
  std::vector<std::pair<std::size_t, vtkIdType>> order; // hash and cell, sorted by hash
  order.reserve(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    const std::vector<vtkIdType> points = pointsOf(grid, i);
    const std::string_view bytes(
      reinterpret_cast<const char*>(points.data()), points.size() * sizeof(vtkIdType));
    order.emplace_back(std::hash<std::string_view>()(bytes), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<bool> isRepeated(static_cast<std::size_t>(count), false);
  for (std::size_t first = 0; first < order.size();)
  {
    std::size_t last = first + 1;
    for (; last < order.size() && order[last].first == order[first].first; ++last)
    {
      const vtkIdType one = order[first].second;
      const vtkIdType other = order[last].second;
      isRepeated[static_cast<std::size_t>(other)] =
        grid->GetCellType(one) == grid->GetCellType(other) &&
        pointsOf(grid, one) == pointsOf(grid, other);
    }
    first = last;
  }
  return isRepeated;
}

/// The three-dimensional cells without repetitions, and the number of cells of each orientation.
struct SolidCells
{
  vtkNew<vtkIdList> all;
  /// Number of cells that are left out because an earlier cell has the same points.
  vtkIdType repeated = 0;
  vtkIdType positive = 0;
  vtkIdType firstPositive = -1;
  vtkIdType negative = 0;
  vtkIdType firstNegative = -1;

  explicit SolidCells(vtkDataSet* data)
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
    const std::vector<bool> isRepeated = grid ? findRepeated(grid) : std::vector<bool>();
    vtkNew<vtkGenericCell> cell;
    for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    {
      data->GetCell(i, cell);
      if (cell->GetCellDimension() != 3)
      {
        continue;
      }
      if (grid && isRepeated[static_cast<std::size_t>(i)])
      {
        ++this->repeated;
        continue;
      }
      this->all->InsertNextId(i);
      const double volume = sixfoldVolume(cell);
      vtkIdType& count = volume > 0.0 ? this->positive : this->negative;
      vtkIdType& first = volume > 0.0 ? this->firstPositive : this->firstNegative;
      count += volume != 0.0;
      first = first < 0 && volume != 0.0 ? i : first;
    }
  }

  std::string fault() const
  {
    if (this->positive == 0 || this->negative == 0)
    {
      return "";
    }
    const bool fewAreNegative = this->negative <= this->positive;
    return joined(fewAreNegative ? this->negative : this->positive, " of ",
      this->positive + this->negative, " cells are inverted, the first is cell ",
      fewAreNegative ? this->firstNegative : this->firstPositive);
  }
};
} // namespace

vtkSmartPointer<vtkPolyData> outerFaces(
  vtkDataSet* data, const int* wholeExtent, std::vector<std::string>& notes, std::string& fault)
{
  vtkSmartPointer<vtkDataSet> volume = data;
  if (!vtkImageData::SafeDownCast(data))
  {
    const SolidCells solid(data);
    fault = solid.fault();
    if (!fault.empty())
    {
      return nullptr;
    }
    auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
    const vtkIdType left = data->GetNumberOfCells() - solid.all->GetNumberOfIds();
    const vtkIdType others = left - solid.repeated;
    if (grid && solid.all->GetNumberOfIds() > 0 && left > 0)
    {
      vtkNew<vtkExtractCells> extract;
      extract->SetInputData(grid);
      extract->SetCellList(solid.all);
      extract->Update();
      volume = extract->GetOutput();
      if (others > 0)
      {
        notes.push_back(joined(others, " cells of fewer than three dimensions left out"));
      }
      if (solid.repeated > 0)
      {
        notes.push_back(joined(solid.repeated, " cells that occur twice left out"));
      }
    }
  }
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(volume);
  if (wholeExtent)
  {
    source->SetWholeExtent(wholeExtent[0], wholeExtent[1], wholeExtent[2], wholeExtent[3],
      wholeExtent[4], wholeExtent[5]);
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputConnection(source->GetOutputPort());
  // With delegation, the order of points would depend on the number of threads.
  surface->DelegationOff();
  surface->Update();
  notes.push_back(joined("surface extracted from ", volume->GetNumberOfCells(), " cells"));
  if (!isStructured(data))
  {
    return surface->GetOutput();
  }
  // A structured grid has separate points at the same position along its edges, and at the seam if
  // the grid closes around an axis. These points are merged.
  vtkNew<vtkStaticCleanPolyData> clean;
  clean->SetInputData(surface->GetOutput());
  clean->ToleranceIsAbsoluteOn();
  clean->SetAbsoluteTolerance(RoundedApart * surface->GetOutput()->GetLength());
  clean->Update();
  return clean->GetOutput();
}
} // namespace palpate
