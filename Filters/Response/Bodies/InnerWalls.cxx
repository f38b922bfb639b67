// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/InnerWalls.h"

#include "Response/Pieces/Ranks.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <unordered_set>

namespace palpate
{
namespace
{
using Corner = std::array<double, 3>;

/**
 * Returns a hash of bytes. `hash` is the start value. A key consists of two hashes with different
 * start values, so that a collision of keys is practically impossible.
 */
std::uint64_t mix(std::uint64_t hash, const void* data, std::size_t size)
{
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < size; ++i)
  {
    hash = (hash ^ bytes[i]) * 1099511628211ULL; // prime of the FNV hash by Fowler, Noll and Vo
  }
  return hash ^ (hash >> 29);
}

struct Key
{
  std::uint64_t first;
  std::uint64_t second;
  bool operator==(const Key& other) const
  {
    return this->first == other.first && this->second == other.second;
  }
};

struct KeyHash
{
  std::size_t operator()(const Key& key) const { return static_cast<std::size_t>(key.first); }
};

/**
 * Returns a key from the corners of a polygon and the name of the block. The key does not depend on
 * the corner at which the polygon begins.
 */
Key keyOf(vtkPolyData* surface, vtkIdType count, const vtkIdType* ids, const std::string& block)
{
  std::vector<Corner> corners(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    surface->GetPoint(ids[i], corners[i].data());
    for (double& c : corners[i])
    {
      c += 0.0; // converts -0 to 0, so that equal coordinates have equal bytes
    }
  }
  std::sort(corners.begin(), corners.end());
  Key key{ mix(14695981039346656037ULL, block.data(), block.size()),
    mix(1469598103934665603ULL, block.data(), block.size()) };
  for (const Corner& corner : corners)
  {
    key.first = mix(key.first, corner.data(), sizeof(Corner));
    key.second = mix(key.second, corner.data(), sizeof(Corner));
  }
  return key;
}

std::vector<Key> keysOf(vtkPolyData* surface, const std::string& block)
{
  std::vector<Key> keys;
  vtkCellArray* polygons = surface->GetPolys();
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (polygons->InitTraversal(); polygons->GetNextCell(count, ids);)
  {
    keys.push_back(keyOf(surface, count, ids, block));
  }
  return keys;
}
} // namespace

void removeInnerWalls(
  std::vector<SurfaceTriangles>& made, const std::vector<std::string>& blocks, const Ranks& ranks)
{
  if (ranks.areAlone())
  {
    return;
  }
  std::vector<std::vector<Key>> own(made.size());
  std::vector<Key> all;
  for (std::size_t i = 0; i < made.size(); ++i)
  {
    if (made[i].surface && made[i].isOfVolume)
    {
      auto withoutGhosts = vtkSmartPointer<vtkPolyData>::New();
      withoutGhosts->ShallowCopy(made[i].surface);
      // This removes the walls of structured pieces, which are faces of ghost cells.
      withoutGhosts->RemoveGhostCells();
      made[i].surface = withoutGhosts;
      own[i] = keysOf(made[i].surface, blocks[i]);
      all.insert(all.end(), own[i].begin(), own[i].end());
    }
  }
  std::unordered_set<Key, KeyHash> others;
  const std::vector<std::vector<Key>> everywhere = ranks.gather(all);
  for (std::size_t rank = 0; rank < everywhere.size(); ++rank)
  {
    if (static_cast<int>(rank) != ranks.own())
    {
      others.insert(everywhere[rank].begin(), everywhere[rank].end());
    }
  }
  for (std::size_t i = 0; i < made.size(); ++i)
  {
    if (own[i].empty())
    {
      continue;
    }
    auto kept = vtkSmartPointer<vtkPolyData>::New();
    kept->DeepCopy(made[i].surface);
    kept->BuildCells();
    vtkIdType polygon = 0;
    for (vtkIdType cell = 0; cell < kept->GetNumberOfCells(); ++cell)
    {
      const int dimension = kept->GetCell(cell)->GetCellDimension();
      if (dimension == 2 && polygon < static_cast<vtkIdType>(own[i].size()) &&
        others.count(own[i][static_cast<std::size_t>(polygon++)]) > 0)
      {
        kept->DeleteCell(cell);
      }
    }
    kept->RemoveDeletedCells();
    vtkNew<vtkCleanPolyData> used; // this removes the points inside the walls
    used->SetInputData(kept);
    used->PointMergingOff();
    used->Update();
    made[i].surface = used->GetOutput();
  }
}
} // namespace palpate
