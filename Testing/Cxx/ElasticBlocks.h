// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ElasticBlocks_h
#define palpate_testing_ElasticBlocks_h

#include "Solids/FiniteElements/ElasticBody.h"

#include <cmath>
#include <map>
#include <utility>

namespace palpate::testing
{
/// A block of nx × ny × nz hexahedra with sides h. One corner is at the origin.
inline VolumeMesh hexahedronBlock(int nx, int ny, int nz, double h)
{
  VolumeMesh mesh;
  mesh.nodes.resize(3, static_cast<Eigen::Index>(nx + 1) * (ny + 1) * (nz + 1));
  const auto id = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  for (int k = 0; k <= nz; ++k)
  {
    for (int j = 0; j <= ny; ++j)
    {
      for (int i = 0; i <= nx; ++i)
      {
        mesh.nodes.col(id(i, j, k)) << i * h, j * h, k * h;
        if (i < nx && j < ny && k < nz)
        {
          VolumeElement element;
          element.nodes = { id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k),
            id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1) };
          mesh.elements.push_back(element);
        }
      }
    }
  }
  return mesh;
}

/// Splits each hexahedron into six tetrahedra around its diagonal (Kuhn). The faces of neighbours
/// match.
inline VolumeMesh tetrahedra(const VolumeMesh& hexahedra)
{
  constexpr std::array<std::array<int, 4>, 6> split = { { { 0, 1, 2, 6 }, { 0, 2, 3, 6 },
    { 0, 3, 7, 6 }, { 0, 7, 4, 6 }, { 0, 4, 5, 6 }, { 0, 5, 1, 6 } } };
  VolumeMesh mesh;
  mesh.nodes = hexahedra.nodes;
  for (const VolumeElement& cube : hexahedra.elements)
  {
    for (const auto& corners : split)
    {
      VolumeElement element;
      element.kind = ElementKind::Tetrahedron;
      for (std::size_t i = 0; i < 4; ++i)
      {
        element.nodes[i] = cube.nodes[static_cast<std::size_t>(corners[i])];
      }
      mesh.elements.push_back(element);
    }
  }
  return mesh;
}

/// Adds a node in the middle of each edge.
inline VolumeMesh quadratic(const VolumeMesh& linear)
{
  constexpr std::array<std::array<std::size_t, 2>, 6> edges = { { { 0, 1 }, { 1, 2 }, { 0, 2 },
    { 0, 3 }, { 1, 3 }, { 2, 3 } } };
  VolumeMesh mesh = linear;
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
  for (VolumeElement& element : mesh.elements)
  {
    element.kind = ElementKind::QuadraticTetrahedron;
    for (std::size_t i = 0; i < 6; ++i)
    {
      const std::pair<std::int32_t, std::int32_t> edge =
        std::minmax(element.nodes[edges[i][0]], element.nodes[edges[i][1]]);
      const auto next =
        static_cast<std::int32_t>(linear.nodes.cols()) + static_cast<std::int32_t>(middles.size());
      element.nodes[4 + i] = middles.emplace(edge, next).first->second;
    }
  }
  mesh.nodes.conservativeResize(3, linear.nodes.cols() + static_cast<Eigen::Index>(middles.size()));
  for (const auto& [edge, node] : middles)
  {
    mesh.nodes.col(node) = 0.5 * (linear.nodes.col(edge.first) + linear.nodes.col(edge.second));
  }
  return mesh;
}

/// Returns 7 (held along x, y and z) for each node with z = 0, and 0 for the others.
inline std::vector<unsigned char> heldBelow(const VolumeMesh& mesh)
{
  std::vector<unsigned char> fixed(static_cast<std::size_t>(mesh.nodeTotal()), 0);
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
  {
    fixed[static_cast<std::size_t>(i)] = mesh.nodes(2, i) == 0.0 ? 7 : 0;
  }
  return fixed;
}

/// Returns 7 (held along x, y and z) for each node up to the given x, and 0 for the others.
inline std::vector<unsigned char> heldTo(const VolumeMesh& mesh, double x)
{
  std::vector<unsigned char> fixed;
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
  {
    fixed.push_back(mesh.nodes(0, i) <= x ? 7 : 0);
  }
  return fixed;
}

/// Returns the elements beyond x. `nodes` receives their node numbers in the whole mesh.
inline VolumeMesh partBeyond(const VolumeMesh& whole, double x, std::vector<std::int32_t>& nodes)
{
  VolumeMesh part;
  std::map<std::int32_t, std::int32_t> number;
  for (VolumeElement element : whole.elements)
  {
    if (elementMiddle(whole, element)[0] < x)
    {
      continue;
    }
    for (int i = 0; i < nodeCount(element.kind); ++i)
    {
      std::int32_t& node = element.nodes[static_cast<std::size_t>(i)];
      const auto [at, isNew] = number.try_emplace(node, static_cast<std::int32_t>(nodes.size()));
      if (isNew)
      {
        nodes.push_back(node);
      }
      node = at->second;
    }
    part.elements.push_back(element);
  }
  part.nodes = whole.nodes(Eigen::all, nodes);
  return part;
}

/// Number of the element whose centre is nearest to a place.
inline std::int32_t elementAt(const VolumeMesh& mesh, const Eigen::Vector3d& place)
{
  const auto away = [&](std::int32_t e)
  { return (elementMiddle(mesh, mesh.elements[static_cast<std::size_t>(e)]) - place).norm(); };
  std::int32_t found = 0;
  for (std::int32_t e = 1; e < mesh.elementTotal(); ++e)
  {
    found = away(e) < away(found) ? e : found;
  }
  return found;
}

/// Number of the surface point at a place, or -1 if there is none.
inline std::int32_t pointAt(const BodySurface& surface, const Eigen::Vector3d& place)
{
  for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
  {
    if ((surface.position(i) - place).norm() < 1e-9)
    {
      return i;
    }
  }
  return -1;
}
} // namespace palpate::testing

#endif
