// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/SurfaceFlaps.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr double LargestShare = 0.1; ///< of the triangles: more are the two sides of a sheet

struct Triangle
{
  std::array<vtkIdType, 3> corners; ///< ascending
  int side;                         ///< 1, or -1 where that turns it round
  vtkIdType cell;

  bool operator<(const Triangle& other) const
  {
    return this->corners != other.corners ? this->corners < other.corners : this->cell < other.cell;
  }
};

std::vector<Triangle> sortedTriangles(vtkPolyData* surface)
{
  std::vector<Triangle> all;
  all.reserve(static_cast<std::size_t>(surface->GetNumberOfPolys()));
  vtkCellArray* polygons = surface->GetPolys();
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (polygons->InitTraversal(); polygons->GetNextCell(count, ids);)
  {
    Triangle made{ { ids[0], ids[1], ids[2] }, 1, static_cast<vtkIdType>(all.size()) };
    for (const auto& [low, high] : { std::pair(0U, 1U), std::pair(1U, 2U), std::pair(0U, 1U) })
    {
      if (made.corners[low] > made.corners[high])
      {
        std::swap(made.corners[low], made.corners[high]);
        made.side = -made.side;
      }
    }
    all.push_back(made);
  }
  std::sort(all.begin(), all.end());
  return all;
}
} // namespace

vtkSmartPointer<vtkPolyData> withoutFlaps(vtkPolyData* surface, vtkIdType& leftOut)
{
  leftOut = 0;
  const std::vector<Triangle> all = sortedTriangles(surface);
  std::vector<vtkIdType> flaps;
  for (auto first = all.begin(); first != all.end();)
  {
    const auto last = std::find_if(
      first, all.end(), [&first](const Triangle& t) { return t.corners != first->corners; });
    int sum = 0;
    for (auto t = first; t != last; ++t)
    {
      sum += t->side;
    }
    bool isKept = false; // the first that faces as most do
    for (auto t = first; t != last; ++t)
    {
      if (isKept || t->side * sum <= 0)
      {
        flaps.push_back(t->cell);
      }
      else
      {
        isKept = true;
      }
    }
    first = last;
  }
  if (flaps.empty() ||
    static_cast<double>(flaps.size()) > LargestShare * static_cast<double>(all.size()))
  {
    return surface;
  }
  auto cleaned = vtkSmartPointer<vtkPolyData>::New();
  cleaned->DeepCopy(surface);
  cleaned->BuildCells();
  for (const vtkIdType cell : flaps)
  {
    cleaned->DeleteCell(cell);
  }
  cleaned->RemoveDeletedCells();
  leftOut = static_cast<vtkIdType>(flaps.size());
  return cleaned;
}
} // namespace palpate
