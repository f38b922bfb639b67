// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/VoxelGrid.h"

#include "Solids/FiniteElements/ElasticElement.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace palpate
{
namespace
{
/// Smallest Jacobian of a hexahedron, as a fraction of the Jacobian of a voxel.
constexpr double SmallestShare = 0.05;
/// Largest number of times that a node is moved back. Each move is a quarter of the remaining
/// distance.
constexpr int MostPullbacks = 12;
constexpr double SmallestStep = 0.1; ///< smallest fraction of the distance to the surface

using Index = std::array<int, 3>;

constexpr std::array<Index, 8> Corners = { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
  { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } } };

template <class Visit>
void forAllIndices(const Index& size, const Visit& visit)
{
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        visit(Index{ i, j, k });
      }
    }
  }
}

/// Returns the number of connected parts that the corners with the state `wanted` form along the
/// edges of a cube.
int partsOf(const std::array<bool, 8>& state, bool wanted)
{
  std::array<int, 8> part{};
  int parts = 0;
  for (std::size_t start = 0; start < 8; ++start)
  {
    if (state[start] != wanted || part[start] != 0)
    {
      continue;
    }
    part[start] = ++parts;
    for (bool grown = true; grown;)
    {
      grown = false;
      for (std::size_t a = 0; a < 8; ++a)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          const std::size_t b = a ^ (std::size_t{ 1 } << axis);
          if (part[a] == parts && state[b] == wanted && part[b] == 0)
          {
            part[b] = parts;
            grown = true;
          }
        }
      }
    }
  }
  return parts;
}
} // namespace

std::size_t VoxelGrid::voxel(int i, int j, int k) const
{
  return (static_cast<std::size_t>(k) * static_cast<std::size_t>(this->size[1]) +
           static_cast<std::size_t>(j)) *
    static_cast<std::size_t>(this->size[0]) +
    static_cast<std::size_t>(i);
}

std::size_t VoxelGrid::node(int i, int j, int k) const
{
  return (static_cast<std::size_t>(k) * static_cast<std::size_t>(this->size[1] + 1) +
           static_cast<std::size_t>(j)) *
    static_cast<std::size_t>(this->size[0] + 1) +
    static_cast<std::size_t>(i);
}

Eigen::Vector3d VoxelGrid::place(int i, int j, int k) const
{
  return this->origin + (Eigen::Array3d(i, j, k) * this->spacing.array()).matrix();
}

bool VoxelGrid::isInside(int i, int j, int k) const
{
  return i >= 0 && j >= 0 && k >= 0 && i < this->size[0] && j < this->size[1] &&
    k < this->size[2] && this->inside[this->voxel(i, j, k)] != 0;
}

void takeCore(VoxelGrid& grid, const std::vector<double>& depthOf, double depth)
{
  grid.inside.assign(grid.voxel(0, 0, grid.size[2]), 0);
  forAllIndices(grid.size,
    [&](const Index& at)
    {
      const bool deep = std::all_of(Corners.begin(), Corners.end(),
        [&](const Index& c)
        { return depthOf[grid.node(at[0] + c[0], at[1] + c[1], at[2] + c[2])] >= depth; });
      grid.inside[grid.voxel(at[0], at[1], at[2])] = deep ? 1 : 0;
    });
}

void openPinches(VoxelGrid& grid)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    forAllIndices({ grid.size[0] + 1, grid.size[1] + 1, grid.size[2] + 1 },
      [&](const Index& at)
      {
        std::array<bool, 8> around{};
        for (std::size_t c = 0; c < 8; ++c)
        {
          around[c] = grid.isInside(at[0] - 1 + static_cast<int>(c & 1U),
            at[1] - 1 + static_cast<int>(c >> 1U & 1U), at[2] - 1 + static_cast<int>(c >> 2U));
        }
        if (partsOf(around, true) <= 1 && partsOf(around, false) <= 1)
        {
          return;
        }
        for (const Index& c : Corners)
        {
          const Index v = { at[0] - 1 + c[0], at[1] - 1 + c[1], at[2] - 1 + c[2] };
          if (grid.isInside(v[0], v[1], v[2]))
          {
            grid.inside[grid.voxel(v[0], v[1], v[2])] = 0;
            changed = true;
          }
        }
      });
  }
}

std::size_t keepLargestPart(VoxelGrid& grid)
{
  std::vector<int> part(grid.inside.size(), 0);
  std::vector<std::size_t> sizes = { 0 };
  std::vector<Index> front;
  const auto visit = [&](const Index& at)
  {
    if (grid.isInside(at[0], at[1], at[2]) && part[grid.voxel(at[0], at[1], at[2])] == 0)
    {
      part[grid.voxel(at[0], at[1], at[2])] = static_cast<int>(sizes.size()) - 1;
      ++sizes.back();
      front.push_back(at);
    }
  };
  forAllIndices(grid.size,
    [&](const Index& start)
    {
      const std::size_t voxel = grid.voxel(start[0], start[1], start[2]);
      if (!grid.inside[voxel] || part[voxel] != 0)
      {
        return;
      }
      sizes.push_back(0);
      visit(start);
      while (!front.empty())
      {
        const Index at = front.back();
        front.pop_back();
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          Index next = at;
          --next[axis];
          visit(next);
          next[axis] += 2;
          visit(next);
        }
      }
    });
  const auto largest =
    static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  std::size_t out = 0;
  for (std::size_t voxel = 0; voxel < grid.inside.size(); ++voxel)
  {
    if (grid.inside[voxel] && part[voxel] != largest)
    {
      grid.inside[voxel] = 0;
      ++out;
    }
  }
  return out;
}

VolumeMesh makeVoxelMesh(const VoxelGrid& grid)
{
  std::vector<std::int32_t> number(grid.nodeTotal(), -1);
  std::vector<Index> nodes;
  VolumeMesh mesh;
  forAllIndices(grid.size,
    [&](const Index& at)
    {
      if (!grid.inside[grid.voxel(at[0], at[1], at[2])])
      {
        return;
      }
      VolumeElement element;
      for (std::size_t c = 0; c < 8; ++c)
      {
        const Index v = { at[0] + Corners[c][0], at[1] + Corners[c][1], at[2] + Corners[c][2] };
        std::int32_t& node = number[grid.node(v[0], v[1], v[2])];
        if (node < 0)
        {
          node = static_cast<std::int32_t>(nodes.size());
          nodes.push_back(v);
        }
        element.nodes[c] = node;
      }
      mesh.elements.push_back(element);
    });
  mesh.nodes.resize(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    mesh.nodes.col(static_cast<Eigen::Index>(i)) =
      grid.place(nodes[i][0], nodes[i][1], nodes[i][2]);
  }
  return mesh;
}

void coverWithLayer(VolumeMesh& mesh, const VoxelGrid& grid,
  const std::function<Eigen::Vector3d(const Eigen::Vector3d&, const Eigen::Vector3d&)>& reach)
{
  MeshTopology topology;
  topology.build(mesh); // this cannot fail for voxels
  const std::int32_t core = mesh.nodeTotal();
  const std::size_t first = mesh.elements.size();
  std::vector<std::int32_t> farOf(static_cast<std::size_t>(core), -1);
  std::vector<std::int32_t> nearOf; // the inner node that belongs to each outer node
  Eigen::Matrix3Xd outward = Eigen::Matrix3Xd::Zero(3, core);
  for (const BoundaryFace& boundary : topology.boundary())
  {
    const VolumeElement below = mesh.elements[static_cast<std::size_t>(boundary.element)];
    const ElementFace& face = elementFace(below.kind, boundary.face);
    VolumeElement element;
    const auto corner = [&](std::size_t i)
    { return mesh.nodes.col(below.nodes[static_cast<std::size_t>(face.node[i])]); };
    const Eigen::Vector3d normal = Eigen::Vector3d(corner(1) - corner(0))
                                     .cross(Eigen::Vector3d(corner(3) - corner(0)))
                                     .normalized();
    for (std::size_t i = 0; i < 4; ++i)
    {
      const std::int32_t near = below.nodes[static_cast<std::size_t>(face.node[i])];
      std::int32_t& far = farOf[static_cast<std::size_t>(near)];
      if (far < 0)
      {
        far = core + static_cast<std::int32_t>(nearOf.size());
        nearOf.push_back(near);
      }
      outward.col(near) += normal;
      element.nodes[i] = near;
      element.nodes[4 + i] = far;
    }
    mesh.elements.push_back(element);
  }
  mesh.nodes.conservativeResize(3, core + static_cast<Eigen::Index>(nearOf.size()));
  Eigen::Matrix3Xd step(3, static_cast<Eigen::Index>(nearOf.size()));
  for (Eigen::Index i = 0; i < step.cols(); ++i)
  {
    const std::int32_t node = nearOf[static_cast<std::size_t>(i)];
    const Eigen::Vector3d near = mesh.nodes.col(node);
    step.col(i) = reach(near, outward.col(node).normalized()) - near;
  }
  std::vector<double> share(nearOf.size(), 1.0);
  const double floor = SmallestShare * grid.spacing.prod() / 8.0;
  for (int pullback = 0; pullback <= MostPullbacks; ++pullback)
  {
    for (Eigen::Index i = 0; i < step.cols(); ++i)
    {
      const auto at = static_cast<std::size_t>(i);
      mesh.nodes.col(core + i) = mesh.nodes.col(nearOf[at]) + share[at] * step.col(i);
    }
    std::vector<unsigned char> spoilt(nearOf.size(), 0);
    bool any = false;
    for (std::size_t e = first; e < mesh.elements.size(); ++e)
    {
      const VolumeElement& element = mesh.elements[e];
      if (!(smallestJacobian(element.kind, elementNodes(mesh, element)) >= floor))
      {
        any = true;
        for (std::size_t i = 4; i < 8; ++i)
        {
          spoilt[static_cast<std::size_t>(element.nodes[i] - core)] = 1;
        }
      }
    }
    if (!any)
    {
      return;
    }
    for (std::size_t i = 0; i < share.size(); ++i)
    {
      share[i] = spoilt[i] ? std::max(0.75 * share[i], SmallestStep) : share[i];
    }
  }
}
} // namespace palpate
