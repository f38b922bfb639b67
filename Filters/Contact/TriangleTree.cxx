// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/TriangleTree.h"

#include "Contact/TriangleBound.h"
#include "Contact/ParallelRanges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
/// Largest number of levels. A tree of 8^11 rows of 32 triangles would have more triangles than an
/// int32 can count.
constexpr std::size_t LargestDepth = 12;

/// A tip that is farther away than this multiple of the body's size is moved to that distance. At
/// larger distances, all distances would round to the same value, so that the search would visit
/// every triangle and the chosen side would be random.
constexpr double FarAway = 1e4;

/// Until a nearer triangle is found, a box with triangles is always within reach, and an empty box
/// never is.
static_assert(
  3.0 * 1.1 * (FarAway * SoundMesh::LargestCoordinate) * (FarAway * SoundMesh::LargestCoordinate) <
    static_cast<double>(std::numeric_limits<float>::max()),
  "squared distances within the horizon fit a float");
} // namespace

void TriangleTree::Boxes::clear()
{
  this->low.fill(Row::Constant(std::numeric_limits<float>::infinity()));
  this->high.fill(Row::Constant(-std::numeric_limits<float>::infinity()));
}

TriangleTree::TriangleTree(const PackedMesh& mesh)
  : Mesh(mesh)
{
  if (mesh.triangleCount() == 0)
  {
    return;
  }
  this->buildLeaves();
  while (this->Levels.back().size() > 1)
  {
    this->buildLevel(this->Levels.back());
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Boxes& all = this->Levels.back().front();
    this->Size = std::max({ this->Size, -static_cast<double>(all.low[k].minCoeff()),
      static_cast<double>(all.high[k].maxCoeff()) });
  }
  this->Horizon = FarAway * this->Size;
}

void TriangleTree::buildLeaves()
{
  const std::size_t triangles = this->Mesh.triangleCount();
  constexpr std::size_t inRow = LeafSize * Width;
  LargeVector<Boxes> rows((triangles + inRow - 1) / inRow);
  forRanges(rows.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t r = first; r < last; ++r)
      {
        Boxes& boxes = rows[r];
        boxes.clear();
        const std::size_t end = std::min(triangles, (r + 1) * inRow);
        for (std::size_t t = r * inRow; t < end; ++t)
        {
          const auto column = static_cast<Eigen::Index>((t - r * inRow) / LeafSize);
          for (int corner = 0; corner < 3; ++corner)
          {
            // The conversion is exact.
            const Eigen::Vector3f p =
              this->Mesh.corner(static_cast<std::int32_t>(t), corner).cast<float>();
            for (std::size_t k = 0; k < 3; ++k)
            {
              float& low = boxes.low[k][column];
              float& high = boxes.high[k][column];
              low = std::min(low, p[static_cast<Eigen::Index>(k)]);
              high = std::max(high, p[static_cast<Eigen::Index>(k)]);
            }
          }
        }
      }
    });
  this->Levels.push_back(std::move(rows));
}

void TriangleTree::buildLevel(const LargeVector<Boxes>& below)
{
  LargeVector<Boxes> rows((below.size() + Width - 1) / Width);
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    rows[r].clear();
    for (std::size_t i = r * Width; i < std::min(below.size(), (r + 1) * Width); ++i)
    {
      const auto column = static_cast<Eigen::Index>(i - r * Width);
      for (std::size_t k = 0; k < 3; ++k)
      {
        rows[r].low[k][column] = below[i].low[k].minCoeff();
        rows[r].high[k][column] = below[i].high[k].maxCoeff();
      }
    }
  }
  this->Levels.push_back(std::move(rows));
}

SurfacePoint TriangleTree::closest(const Vector3& tip) const noexcept
{
  SurfacePoint found = this->closestLocal(this->Mesh.toLocal(tip));
  found.projection.point += this->Mesh.centre();
  return found;
}

SurfacePoint TriangleTree::closestLocal(const Vector3& tip) const noexcept
{
  if (this->Levels.empty() || !tip.allFinite())
  {
    return {};
  }
  if (!this->isBeyondHorizon(tip))
  {
    return this->closestWithin(tip);
  }
  SurfacePoint found = this->closestWithin(tip / tip.cwiseAbs().maxCoeff() * this->Horizon);
  const double distance = (tip - found.projection.point).stableNorm();
  found.projection.squaredDistance = distance * distance;
  found.signedDistance = std::copysign(distance, found.signedDistance);
  return found;
}

SurfacePoint TriangleTree::closestWithin(const Vector3& tip) const noexcept
{
  struct Pending
  {
    float squaredDistance;
    std::uint32_t level; ///< level of the row
    std::size_t row;
  };
  std::array<Pending, (Width - 1) * LargestDepth + 1> stack;
  std::size_t size = 0;
  const Eigen::Vector3f rounded = tip.cast<float>();
  NearestTriangle nearest(tip, this->Size);
  stack[size++] = { 0.0F, static_cast<std::uint32_t>(this->Levels.size() - 1), 0 };
  while (size > 0)
  {
    const Pending next = stack[--size];
    if (next.squaredDistance > nearest.boxReach())
    {
      continue;
    }
    const Row distances = this->Levels[next.level][next.row].squaredDistances(rounded);
    // Collects the boxes within reach. The nearest box is last, so that it is taken from the stack
    // first.
    const std::size_t bottom = size;
    std::array<Pending, Width> leaves;
    std::size_t leafCount = 0;
    for (std::size_t k = 0; k < Width; ++k)
    {
      const float distance = distances[static_cast<Eigen::Index>(k)];
      if (!(distance <= nearest.boxReach()))
      {
        continue;
      }
      const Pending child{ distance, next.level - 1, next.row * Width + k };
      Pending* first = next.level == 0 ? leaves.data() : stack.data() + bottom;
      std::size_t& count = next.level == 0 ? leafCount : size;
      Pending* place = next.level == 0 ? first + leafCount : stack.data() + size;
      ++count;
      while (place != first && place[-1].squaredDistance < distance)
      {
        *place = place[-1];
        --place;
      }
      *place = child;
    }
    for (std::size_t i = leafCount; i-- > 0;)
    {
      if (leaves[i].squaredDistance > nearest.boxReach())
      {
        break;
      }
      this->searchLeaf(leaves[i].row, tip, rounded, nearest);
    }
  }
  return nearest.triangle() < 0 ? SurfacePoint{}
                                : this->Mesh.orient(tip, nearest.triangle(), nearest.projection());
}

void TriangleTree::searchLeaf(std::size_t leaf, const Vector3& tip, const Eigen::Vector3f& rounded,
  NearestTriangle& nearest) const noexcept
{
  const std::size_t first = leaf * LeafSize;
  const std::size_t last = this->Mesh.triangleCount() - 1;
  std::array<const float*, LeafSize> corners;
  for (std::size_t i = 0; i < LeafSize; ++i)
  {
    corners[i] = this->Mesh.coordinates(static_cast<std::int32_t>(std::min(first + i, last)));
  }
  const TriangleBound::Lane bounds = TriangleBound::squaredDistances(rounded, corners);
  for (std::size_t i = 0; i < LeafSize && first + i <= last; ++i)
  {
    const auto triangle = static_cast<std::int32_t>(first + i);
    if (!nearest.canReach(bounds[static_cast<Eigen::Index>(i)]) || triangle == nearest.triangle())
    {
      continue;
    }
    const TriangleProjection there = this->Mesh.project(tip, triangle);
    const double best = nearest.projection().squaredDistance;
    if (there.squaredDistance < best ||
      (there.squaredDistance == best && this->comesFirst(rounded, triangle, nearest.triangle())))
    {
      nearest.take(triangle, there);
    }
  }
}

bool TriangleTree::comesFirst(
  const Eigen::Vector3f& rounded, std::int32_t triangle, std::int32_t other) const noexcept
{
  std::size_t a = static_cast<std::size_t>(triangle) / LeafSize;
  std::size_t b = static_cast<std::size_t>(other) / LeafSize;
  if (other < 0 || a == b)
  {
    return triangle < other;
  }
  std::size_t level = 0;
  for (; a / Width != b / Width; ++level)
  {
    a /= Width;
    b /= Width;
  }
  const Row distances = this->Levels[level][a / Width].squaredDistances(rounded);
  const float toA = distances[static_cast<Eigen::Index>(a % Width)];
  const float toB = distances[static_cast<Eigen::Index>(b % Width)];
  return toA < toB || (toA == toB && a > b); // triangles are ordered as closestWithin() visits them
}

std::size_t TriangleTree::memory() const noexcept
{
  std::size_t rows = 0;
  for (const LargeVector<Boxes>& level : this->Levels)
  {
    rows += level.size();
  }
  return rows * sizeof(Boxes);
}
} // namespace palpate
