// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/SurfaceFlaps.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cstdint>
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

/// Calls visit(triangle) for each one, in the order of the cells.
template <class Visit>
void visitTriangles(vtkPolyData* surface, const Visit& visit)
{
  vtkCellArray* polygons = surface->GetPolys();
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  vtkIdType cell = 0;
  for (polygons->InitTraversal(); polygons->GetNextCell(count, ids); ++cell)
  {
    Triangle made{ { ids[0], ids[1], ids[2] }, 1, cell };
    for (const auto& [low, high] : { std::pair(0U, 1U), std::pair(1U, 2U), std::pair(0U, 1U) })
    {
      if (made.corners[low] > made.corners[high])
      {
        std::swap(made.corners[low], made.corners[high]);
        made.side = -made.side;
      }
    }
    visit(made);
  }
}

/// The same for the same corners, and seldom for others.
std::uint64_t keyOf(const Triangle& triangle)
{
  std::uint64_t key = 0;
  for (const vtkIdType corner : triangle.corners)
  {
    key = (key ^ static_cast<std::uint64_t>(corner)) * 0x9e3779b97f4a7c15ULL; // Knuth
    key ^= key >> 32U;
  }
  return key;
}

/// Keys that more than one triangle has, ascending.
std::vector<std::uint64_t> sharedKeys(vtkPolyData* surface)
{
  std::vector<std::uint64_t> keys;
  keys.reserve(static_cast<std::size_t>(surface->GetNumberOfPolys()));
  visitTriangles(surface, [&keys](const Triangle& made) { keys.push_back(keyOf(made)); });
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint64_t> shared;
  for (std::size_t i = 1; i < keys.size(); ++i)
  {
    if (keys[i] == keys[i - 1] && (shared.empty() || shared.back() != keys[i]))
    {
      shared.push_back(keys[i]);
    }
  }
  return shared;
}

/// Those with such keys, sorted.
std::vector<Triangle> sortedTriangles(
  vtkPolyData* surface, const std::vector<std::uint64_t>& shared)
{
  std::vector<Triangle> found;
  visitTriangles(surface,
    [&](const Triangle& made)
    {
      if (std::binary_search(shared.begin(), shared.end(), keyOf(made)))
      {
        found.push_back(made);
      }
    });
  std::sort(found.begin(), found.end());
  return found;
}
} // namespace

vtkSmartPointer<vtkPolyData> withoutFlaps(vtkPolyData* surface)
{
  const std::vector<std::uint64_t> shared = sharedKeys(surface);
  if (shared.empty())
  {
    return surface;
  }
  const std::vector<Triangle> all = sortedTriangles(surface, shared);
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
    static_cast<double>(flaps.size()) >
      LargestShare * static_cast<double>(surface->GetNumberOfPolys()))
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
  return cleaned;
}
} // namespace palpate
