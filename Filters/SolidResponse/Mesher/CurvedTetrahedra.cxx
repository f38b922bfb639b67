// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Mesher/CurvedTetrahedra.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <map>
#include <utility>

namespace palpate
{
namespace
{
constexpr double LeastJacobian = 0.1;

/// For each mid-edge node, the corners at the ends of its edge, in VTK's numbering.
constexpr int TetrahedronEdges[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 },
  { 2, 3 } };
constexpr int TetrahedronFaces[4][3] = { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 2, 1 } };

using Edge = std::pair<std::int32_t, std::int32_t>;

Edge edgeOf(std::int32_t a, std::int32_t b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// Returns the edges of the faces that belong to only one tetrahedron.
std::vector<Edge> outerEdges(const TetrahedralMesh& mesh)
{
  std::vector<std::array<std::int32_t, 3>> faces;
  faces.reserve(4 * mesh.cells.size());
  for (const auto& cell : mesh.cells)
  {
    for (const auto& face : TetrahedronFaces)
    {
      std::array<std::int32_t, 3> ids{};
      std::transform(
        face, face + 3, ids.begin(), [&](int i) { return cell[static_cast<std::size_t>(i)]; });
      std::sort(ids.begin(), ids.end());
      faces.push_back(ids);
    }
  }
  std::sort(faces.begin(), faces.end());
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (i + 1 < faces.size() && faces[i] == faces[i + 1])
    {
      ++i; // this face belongs to two tetrahedra
      continue;
    }
    edges.push_back({ faces[i][0], faces[i][1] });
    edges.push_back({ faces[i][1], faces[i][2] });
    edges.push_back({ faces[i][0], faces[i][2] });
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}
} // namespace

double leastJacobian(const Eigen::Matrix3Xd& nodes, const std::array<std::int32_t, 10>& cell)
{
  // In barycentric coordinates λ, x = Σ λ_i(2λ_i - 1)x_i + 4Σ λ_iλ_j x_ij. The derivative dx/dλ is
  // linear in λ. At corner k, dx/dλ_i is 4x_ik - x_i for i ≠ k and 3x_k for i = k.
  std::array<Eigen::Matrix3d, 4> at;
  const auto node = [&](int i) -> Eigen::Vector3d
  { return nodes.col(cell[static_cast<std::size_t>(i)]); };
  std::array<std::array<int, 4>, 4> middle{};
  for (int e = 0; e < 6; ++e)
  {
    const auto a = static_cast<std::size_t>(TetrahedronEdges[e][0]);
    const auto b = static_cast<std::size_t>(TetrahedronEdges[e][1]);
    middle[a][b] = middle[b][a] = 4 + e;
  }
  for (int k = 0; k < 4; ++k)
  {
    const auto along = [&](int i) -> Eigen::Vector3d
    {
      return i == k
        ? Eigen::Vector3d(3.0 * node(i))
        : Eigen::Vector3d(
            4.0 * node(middle[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]) - node(i));
    };
    for (int c = 0; c < 3; ++c)
    {
      at[static_cast<std::size_t>(k)].col(c) = along(c + 1) - along(0);
    }
  }
  Eigen::Matrix3d straight;
  straight << node(1) - node(0), node(2) - node(0), node(3) - node(0);
  const auto mixed = [&](std::size_t i, std::size_t j, std::size_t k)
  { return at[i].col(0).dot(at[j].col(1).cross(at[k].col(2))); };
  double least = 1e300;
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = i; j < 4; ++j)
    {
      for (std::size_t k = j; k < 4; ++k)
      {
        least = std::min(least,
          (mixed(i, j, k) + mixed(i, k, j) + mixed(j, i, k) + mixed(j, k, i) + mixed(k, i, j) +
            mixed(k, j, i)) /
            6.0);
      }
    }
  }
  return least / straight.determinant();
}

CurvedTetrahedra curveTetrahedra(const TetrahedralMesh& mesh, const EdgeReach& reach)
{
  const std::vector<Edge> outer = outerEdges(mesh);
  std::map<Edge, std::int32_t> number;
  for (const auto& cell : mesh.cells)
  {
    for (const auto& ends : TetrahedronEdges)
    {
      number.try_emplace(
        edgeOf(cell[static_cast<std::size_t>(ends[0])], cell[static_cast<std::size_t>(ends[1])]),
        0);
    }
  }
  CurvedTetrahedra made;
  const Eigen::Index corners = mesh.nodes.cols();
  made.nodes.resize(3, corners + static_cast<Eigen::Index>(number.size()));
  made.nodes.leftCols(corners) = mesh.nodes;
  Eigen::Index next = corners;
  for (auto& [edge, id] : number)
  {
    id = static_cast<std::int32_t>(next++);
    const Eigen::Vector3d middle = 0.5 * (mesh.nodes.col(edge.first) + mesh.nodes.col(edge.second));
    const bool isOuter = std::binary_search(outer.begin(), outer.end(), edge);
    const bool isSharp = std::binary_search(mesh.sharpEdges.begin(), mesh.sharpEdges.end(),
      std::array<std::int32_t, 2>{ edge.first, edge.second });
    made.nodes.col(id) = isOuter ? reach(middle, isSharp) : middle;
  }
  made.cells.reserve(mesh.cells.size());
  for (const auto& cell : mesh.cells)
  {
    std::array<std::int32_t, 10> ids{};
    std::copy(cell.begin(), cell.end(), ids.begin());
    for (std::size_t e = 0; e < 6; ++e)
    {
      ids[4 + e] = number.at(edgeOf(cell[static_cast<std::size_t>(TetrahedronEdges[e][0])],
        cell[static_cast<std::size_t>(TetrahedronEdges[e][1])]));
    }
    made.cells.push_back(ids);
  }
  // A straightened edge can make the Jacobian of a neighbouring cell too small, so the loop is
  // repeated until nothing changes.
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    for (const auto& cell : made.cells)
    {
      if (leastJacobian(made.nodes, cell) >= LeastJacobian)
      {
        continue;
      }
      for (std::size_t e = 0; e < 6; ++e)
      {
        const Eigen::Vector3d middle = 0.5 *
          (made.nodes.col(cell[static_cast<std::size_t>(TetrahedronEdges[e][0])]) +
            made.nodes.col(cell[static_cast<std::size_t>(TetrahedronEdges[e][1])]));
        if (made.nodes.col(cell[4 + e]) != middle)
        {
          made.nodes.col(cell[4 + e]) = middle;
          ++made.straightened;
          isChanged = true;
        }
      }
    }
  }
  return made;
}
} // namespace palpate
