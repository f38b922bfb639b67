// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/VolumeMesh.h"

#include <algorithm>
#include <numeric>

namespace palpate
{
namespace
{
constexpr std::array<ElementFace, 6> HexahedronFaces = { { { 4, 4, { 0, 4, 7, 3 } },
  { 4, 4, { 1, 2, 6, 5 } }, { 4, 4, { 0, 1, 5, 4 } }, { 4, 4, { 3, 7, 6, 2 } },
  { 4, 4, { 0, 3, 2, 1 } }, { 4, 4, { 4, 5, 6, 7 } } } };
constexpr std::array<ElementFace, 4> TetrahedronFaces = { { { 3, 3, { 0, 1, 3 } },
  { 3, 3, { 1, 2, 3 } }, { 3, 3, { 2, 0, 3 } }, { 3, 3, { 0, 2, 1 } } } };
constexpr std::array<ElementFace, 4> QuadraticFaces = { { { 3, 6, { 0, 1, 3, 4, 8, 7 } },
  { 3, 6, { 1, 2, 3, 5, 9, 8 } }, { 3, 6, { 2, 0, 3, 6, 7, 9 } },
  { 3, 6, { 0, 2, 1, 6, 5, 4 } } } };

struct FaceRecord
{
  std::array<std::int32_t, 4> corners; // node numbers in ascending order
  std::int32_t element;
  int face;
};

std::int32_t rootOf(std::vector<std::int32_t>& parent, std::int32_t i)
{
  while (parent[static_cast<std::size_t>(i)] != i)
  {
    std::int32_t& up = parent[static_cast<std::size_t>(i)];
    up = parent[static_cast<std::size_t>(up)];
    i = up;
  }
  return i;
}
} // namespace

std::vector<std::int32_t> partOfNodes(const VolumeMesh& mesh)
{
  std::vector<std::int32_t> parent(static_cast<std::size_t>(mesh.nodeTotal()));
  std::iota(parent.begin(), parent.end(), 0);
  for (const VolumeElement& element : mesh.elements)
  {
    const std::int32_t root = rootOf(parent, element.nodes[0]);
    for (int i = 1; i < nodeCount(element.kind); ++i)
    {
      parent[static_cast<std::size_t>(rootOf(parent, element.nodes[static_cast<std::size_t>(i)]))] =
        root;
    }
  }
  for (std::int32_t i = 0; i < mesh.nodeTotal(); ++i)
  {
    parent[static_cast<std::size_t>(i)] = rootOf(parent, i);
  }
  return parent;
}

int nodeCount(ElementKind kind)
{
  return kind == ElementKind::Hexahedron ? 8 : kind == ElementKind::Tetrahedron ? 4 : 10;
}

int faceCount(ElementKind kind)
{
  return kind == ElementKind::Hexahedron ? 6 : 4;
}

const ElementFace& elementFace(ElementKind kind, int face)
{
  const auto f = static_cast<std::size_t>(face);
  return kind == ElementKind::Hexahedron ? HexahedronFaces[f]
    : kind == ElementKind::Tetrahedron   ? TetrahedronFaces[f]
                                         : QuadraticFaces[f];
}

Eigen::Vector3d elementMiddle(const VolumeMesh& mesh, const VolumeElement& element)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const int count = nodeCount(element.kind);
  for (int i = 0; i < count; ++i)
  {
    sum += mesh.nodes.col(element.nodes[static_cast<std::size_t>(i)]);
  }
  return sum / count;
}

std::string MeshTopology::build(const VolumeMesh& mesh)
{
  std::vector<FaceRecord> faces;
  faces.reserve(mesh.elements.size() * 6);
  this->NodeOffset.assign(static_cast<std::size_t>(mesh.nodeTotal()) + 1, 0);
  for (std::int32_t e = 0; e < mesh.elementTotal(); ++e)
  {
    const VolumeElement& element = mesh.elements[static_cast<std::size_t>(e)];
    for (int f = 0; f < faceCount(element.kind); ++f)
    {
      const ElementFace& face = elementFace(element.kind, f);
      FaceRecord record{ { -1, -1, -1, -1 }, e, f };
      for (std::size_t i = 0; i < static_cast<std::size_t>(face.corners); ++i)
      {
        record.corners[i] = element.nodes[static_cast<std::size_t>(face.node[i])];
      }
      std::sort(record.corners.begin(), record.corners.end());
      faces.push_back(record);
    }
    for (int i = 0; i < nodeCount(element.kind); ++i)
    {
      ++this->NodeOffset[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(i)]) + 1];
    }
  }
  // After sorting, equal faces are adjacent. The faces of a pair, and the boundary faces, are in
  // the order of the elements.
  std::vector<std::size_t> order(faces.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  std::sort(order.begin(), order.end(),
    [&faces](std::size_t a, std::size_t b)
    { return faces[a].corners != faces[b].corners ? faces[a].corners < faces[b].corners : a < b; });

  this->Across.assign(mesh.elements.size(), { -1, -1, -1, -1, -1, -1 });
  std::vector<unsigned char> paired(faces.size(), 0);
  for (std::size_t i = 0; i + 1 < order.size(); ++i)
  {
    const FaceRecord& a = faces[order[i]];
    const FaceRecord& b = faces[order[i + 1]];
    if (a.corners != b.corners)
    {
      continue;
    }
    if (i + 2 < order.size() && faces[order[i + 2]].corners == a.corners)
    {
      return "more than two cells share a face: cells " + std::to_string(a.element) + ", " +
        std::to_string(b.element) + ", " + std::to_string(faces[order[i + 2]].element);
    }
    this->Across[static_cast<std::size_t>(a.element)][static_cast<std::size_t>(a.face)] = b.element;
    this->Across[static_cast<std::size_t>(b.element)][static_cast<std::size_t>(b.face)] = a.element;
    paired[order[i]] = paired[order[i + 1]] = 1;
  }
  this->Boundary.clear();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (!paired[i])
    {
      this->Across[static_cast<std::size_t>(faces[i].element)][static_cast<std::size_t>(
        faces[i].face)] = -1 - static_cast<std::int32_t>(this->Boundary.size());
      this->Boundary.push_back({ faces[i].element, faces[i].face });
    }
  }

  for (std::size_t i = 1; i < this->NodeOffset.size(); ++i)
  {
    this->NodeOffset[i] += this->NodeOffset[i - 1];
  }
  this->NodeElements.resize(this->NodeOffset.back());
  std::vector<std::size_t> next(this->NodeOffset.begin(), this->NodeOffset.end() - 1);
  for (std::int32_t e = 0; e < mesh.elementTotal(); ++e)
  {
    const VolumeElement& element = mesh.elements[static_cast<std::size_t>(e)];
    for (int i = 0; i < nodeCount(element.kind); ++i)
    {
      this->NodeElements[next[static_cast<std::size_t>(
        element.nodes[static_cast<std::size_t>(i)])]++] = e;
    }
  }
  return {};
}

std::vector<std::int32_t> elementsHeldByFaces(
  const VolumeMesh& mesh, const MeshTopology& topology, const std::vector<unsigned char>& held)
{
  std::vector<std::int32_t> reached;
  std::vector<unsigned char> isReached(mesh.elements.size(), 0);
  const auto reach = [&](std::int32_t e)
  {
    if (e >= 0 && isReached[static_cast<std::size_t>(e)] == 0)
    {
      isReached[static_cast<std::size_t>(e)] = 1;
      reached.push_back(e);
    }
  };
  for (const BoundaryFace& boundary : topology.boundary())
  {
    const VolumeElement& element = mesh.elements[static_cast<std::size_t>(boundary.element)];
    const ElementFace& face = elementFace(element.kind, boundary.face);
    const auto isHeld = [&](int corner) {
      return held[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(corner)])] != 0;
    };
    const auto* const first = face.node.begin();
    reach(std::all_of(first, first + face.corners, isHeld) ? boundary.element : -1);
  }
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    const std::int32_t e = reached[i];
    const ElementKind kind = mesh.elements[static_cast<std::size_t>(e)].kind;
    for (int face = 0; face < faceCount(kind); ++face)
    {
      reach(topology.across(e, face));
    }
  }
  std::sort(reached.begin(), reached.end());
  return reached;
}
} // namespace palpate
