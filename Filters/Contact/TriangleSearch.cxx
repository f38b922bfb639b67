// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/TriangleTree.h"

#include "Contact/TriangleBound.h"

#include <cmath>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace palpate
{
namespace
{
/// Returns eight bits: bit k is set if distances[k] is at most `reach`.
unsigned within(const Eigen::Array<float, 8, 1>& distances, float reach) noexcept
{
#ifdef __SSE2__
  const __m128 limit = _mm_set1_ps(reach);
  const int low = _mm_movemask_ps(_mm_cmple_ps(_mm_loadu_ps(distances.data()), limit));
  const int high = _mm_movemask_ps(_mm_cmple_ps(_mm_loadu_ps(distances.data() + 4), limit));
  return static_cast<unsigned>(low | high << 4);
#else
  unsigned bits = 0;
  for (Eigen::Index k = 0; k < distances.size(); ++k)
  {
    bits |= static_cast<unsigned>(distances[k] <= reach) << k;
  }
  return bits;
#endif
}

/// Calls visit(k) for each bit k that is set.
template <class Visit>
void forBits(unsigned bits, const Visit& visit) noexcept
{
  for (; bits != 0; bits &= bits - 1)
  {
    visit(static_cast<std::size_t>(__builtin_ctz(bits)));
  }
}
} // namespace

SurfacePoint TriangleSearch::closestLocal(const Vector3& tip) noexcept
{
  SurfacePoint found;
  if (this->Last >= 0 && tip.allFinite() && !this->Tree.isBeyondHorizon(tip))
  {
    const Place near = this->walk(tip);
    const double reach = std::sqrt(near.projection.squaredDistance);
    if (this->isGathered(tip, reach) || this->gather(tip, near, reach))
    {
      found = this->searchGathered(tip, near);
    }
  }
  if (found.triangle < 0)
  {
    found = this->Tree.closestLocal(tip);
  }
  this->Last = found.triangle;
  return found;
}

TriangleSearch::Place TriangleSearch::walk(const Vector3& tip) const noexcept
{
  const PackedMesh& mesh = this->Tree.Mesh;
  Place place{ this->Last, {} };
  for (int step = 0; step < MaximumSteps; ++step)
  {
    const PlaneFoot foot = mesh.projectOnFace(tip, place.triangle, place.projection);
    if (foot == PlaneFoot::OnFace)
    {
      return place;
    }
    const std::int32_t across =
      foot == PlaneFoot::Unknown ? -1 : mesh.neighbour(place.triangle, static_cast<int>(foot));
    if (across < 0)
    {
      break;
    }
    place.triangle = across;
  }
  place.projection = mesh.project(tip, place.triangle);
  return place;
}

bool TriangleSearch::gather(const Vector3& tip, const Place& near, double reach) noexcept
{
  const auto row = static_cast<std::size_t>(near.triangle) / (Width * TriangleTree::LeafSize);
  const TriangleTree::Boxes& here = this->Tree.Levels.front()[row];
  double size2 = 0.0; // squared diagonal of the box around this row
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double side{ here.high[k].maxCoeff() - here.low[k].minCoeff() };
    size2 += side * side;
  }
  this->Radius = -1.0;
  if (reach * reach > size2)
  {
    return false; // there are too many boxes
  }
  const double radius = reach + 0.5 * std::sqrt(size2);
  NearestTriangle around(tip, this->Tree.Size);
  TriangleProjection rim;
  rim.squaredDistance = radius * radius;
  around.take(-1, rim);

  struct Pending
  {
    std::uint32_t level;
    std::uint32_t row;
  };
  // 13 levels suffice for int32 indices, see TriangleTree.cxx.
  std::array<Pending, Width * 13> stack;
  std::size_t size = 0;
  const Eigen::Vector3f rounded = tip.cast<float>();
  this->Count = 0;
  stack[size++] = { static_cast<std::uint32_t>(this->Tree.Levels.size() - 1), 0 };
  while (size > 0)
  {
    const Pending next = stack[--size];
    const TriangleTree::Boxes& boxes = this->Tree.Levels[next.level][next.row];
    if (next.level > 0)
    {
      forBits(within(boxes.squaredDistances(rounded), around.boxReach()),
        [&](std::size_t k) {
          stack[size++] = { next.level - 1, static_cast<std::uint32_t>(next.row * Width + k) };
        });
      continue;
    }
    if (this->Count == Capacity)
    {
      return false;
    }
    TriangleTree::Boxes& to = this->Boxes[this->Count / Width];
    const auto column = static_cast<Eigen::Index>(this->Count % Width);
    if (column == 0)
    {
      to.clear();
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      to.low[k][column] = boxes.low[k].minCoeff();
      to.high[k][column] = boxes.high[k].maxCoeff();
    }
    this->Rows[this->Count++] = next.row;
  }
  this->Centre = tip;
  this->Radius = radius;
  return true;
}

SurfacePoint TriangleSearch::searchGathered(const Vector3& tip, const Place& near) const noexcept
{
  const Eigen::Vector3f rounded = tip.cast<float>();
  NearestTriangle nearest(tip, this->Tree.Size);
  nearest.take(near.triangle, near.projection);
  for (std::size_t i = 0; i < this->Count; i += Width)
  {
    forBits(within(this->Boxes[i / Width].squaredDistances(rounded), nearest.boxReach()),
      [&](std::size_t k)
      {
        const std::size_t row = this->Rows[i + k];
        forBits(
          within(this->Tree.Levels.front()[row].squaredDistances(rounded), nearest.boxReach()),
          [&](std::size_t leaf)
          { this->Tree.searchLeaf(row * Width + leaf, tip, rounded, nearest); });
      });
  }
  return this->Tree.Mesh.orient(tip, nearest.triangle(), nearest.projection());
}
} // namespace palpate
