// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleTree.h"

#include <algorithm>
#include <array>
#include <limits>

namespace palpate
{
namespace
{
constexpr std::int32_t LeafSize = 4;
constexpr std::size_t StackSize = 64;

Eigen::AlignedBox3d boxOf(const BodyMesh& mesh, std::int32_t triangle)
{
  Eigen::AlignedBox3d box;
  for (const std::int32_t corner : mesh.corners(triangle))
  {
    box.extend(mesh.point(corner));
  }
  return box;
}
} // namespace

TriangleTree::TriangleTree(const BodyMesh& mesh)
  : Mesh(mesh)
{
  const auto count = static_cast<std::int32_t>(mesh.triangleCount());
  std::vector<Vector3> centres(mesh.triangleCount(), Vector3::Zero());
  for (std::int32_t t = 0; t < count; ++t)
  {
    if (mesh.isUsable(t))
    {
      this->Order.push_back(t);
      centres[static_cast<std::size_t>(t)] = boxOf(mesh, t).center();
    }
  }
  if (!this->Order.empty())
  {
    this->Nodes.reserve(this->Order.size());
    this->build(0, static_cast<std::int32_t>(this->Order.size()), centres);
  }
}

std::int32_t TriangleTree::build(
  std::int32_t first, std::int32_t last, const std::vector<Vector3>& centres)
{
  const auto index = static_cast<std::int32_t>(this->Nodes.size());
  this->Nodes.push_back({ {}, first, last - first });
  Eigen::AlignedBox3d box;
  Eigen::AlignedBox3d spread;
  for (std::int32_t i = first; i < last; ++i)
  {
    const std::int32_t triangle = this->Order[static_cast<std::size_t>(i)];
    box.extend(boxOf(this->Mesh, triangle));
    spread.extend(centres[static_cast<std::size_t>(triangle)]);
  }
  this->Nodes[static_cast<std::size_t>(index)].box = box;
  if (last - first > LeafSize)
  {
    Eigen::Index axis = 0;
    spread.sizes().maxCoeff(&axis);
    const std::int32_t middle = first + (last - first) / 2;
    std::nth_element(this->Order.begin() + first, this->Order.begin() + middle,
      this->Order.begin() + last,
      [&centres, axis](std::int32_t a, std::int32_t b)
      {
        const double ca = centres[static_cast<std::size_t>(a)][axis];
        const double cb = centres[static_cast<std::size_t>(b)][axis];
        return ca < cb || (ca == cb && a < b);
      });
    this->build(first, middle, centres);
    const std::int32_t right = this->build(middle, last, centres);
    this->Nodes[static_cast<std::size_t>(index)].first = right;
    this->Nodes[static_cast<std::size_t>(index)].count = 0;
  }
  return index;
}

SurfacePoint TriangleTree::closest(const Vector3& tip) const noexcept
{
  if (this->Nodes.empty() || !tip.allFinite())
  {
    return {};
  }
  struct Pending
  {
    std::int32_t node;
    double squaredDistance;
  };
  std::array<Pending, StackSize> stack;
  std::size_t size = 0;
  stack[size++] = { 0, this->Nodes[0].box.squaredExteriorDistance(tip) };
  std::int32_t nearest = -1;
  TriangleProjection best;
  best.squaredDistance = std::numeric_limits<double>::infinity();
  while (size > 0)
  {
    const Pending next = stack[--size];
    if (next.squaredDistance > best.squaredDistance)
    {
      continue;
    }
    const Node& node = this->Nodes[static_cast<std::size_t>(next.node)];
    for (std::int32_t i = node.first; i < node.first + node.count; ++i)
    {
      const std::int32_t triangle = this->Order[static_cast<std::size_t>(i)];
      const TriangleProjection candidate = this->Mesh.project(tip, triangle);
      if (candidate.squaredDistance < best.squaredDistance)
      {
        best = candidate;
        nearest = triangle;
      }
    }
    if (node.count == 0)
    {
      const auto distanceTo = [&](std::int32_t child)
      { return this->Nodes[static_cast<std::size_t>(child)].box.squaredExteriorDistance(tip); };
      Pending left{ next.node + 1, distanceTo(next.node + 1) };
      Pending right{ node.first, distanceTo(node.first) };
      if (left.squaredDistance > right.squaredDistance)
      {
        std::swap(left, right);
      }
      stack[size++] = right;
      stack[size++] = left;
    }
  }
  return nearest < 0 ? SurfacePoint{} : this->Mesh.orient(tip, nearest, best);
}
} // namespace palpate
