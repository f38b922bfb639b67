// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_VolumeMesh_h
#define palpate_VolumeMesh_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{
/// Type of an element. Corner and mid-edge nodes are numbered as in VTK_HEXAHEDRON, VTK_TETRA and
/// VTK_QUADRATIC_TETRA.
enum class ElementKind : std::uint8_t
{
  Hexahedron,
  Tetrahedron,
  QuadraticTetrahedron
};

constexpr int LargestNodeCount = 10;

PALPATE_EXPORT int nodeCount(ElementKind kind);
PALPATE_EXPORT int faceCount(ElementKind kind);

/// One side of an element, in the element's node numbers. The corners are first, counter-clockwise
/// as seen from outside, followed by the mid-edge nodes. The first mid-edge node is between the
/// first two corners.
struct ElementFace
{
  int corners = 0; ///< number of corners, 3 or 4
  int nodes = 0;   ///< number of nodes, 3, 4 or 6
  std::array<int, 6> node{};
};
PALPATE_EXPORT const ElementFace& elementFace(ElementKind kind, int face);

/// One element, with its kind and its nodes.
struct VolumeElement
{
  ElementKind kind = ElementKind::Hexahedron;
  std::array<std::int32_t, LargestNodeCount> nodes{};
};

/// A body as nodes (mm) and elements that share them.
struct VolumeMesh
{
  Eigen::Matrix3Xd nodes;
  std::vector<VolumeElement> elements;

  std::int32_t nodeTotal() const { return static_cast<std::int32_t>(this->nodes.cols()); }
  std::int32_t elementTotal() const { return static_cast<std::int32_t>(this->elements.size()); }
};

/// Returns the mean position of an element's nodes.
PALPATE_EXPORT Eigen::Vector3d elementMiddle(const VolumeMesh& mesh, const VolumeElement& element);

/// Returns a part number for each node. It is equal for all nodes of a part of the mesh that is
/// connected by shared nodes.
PALPATE_EXPORT std::vector<std::int32_t> partOfNodes(const VolumeMesh& mesh);

/// A face of the body's surface. It is the face `face` of the element `element`.
struct BoundaryFace
{
  std::int32_t element = 0;
  int face = 0;
};

/**
 * The neighbours of elements, and the faces on the body's surface.
 *
 * Two elements are neighbours if a face of one has the same corner nodes as a face of the other. A
 * face of more than two elements is a fault. Cost: one sort of all faces.
 */
class PALPATE_EXPORT MeshTopology
{
public:
  /// Finds the neighbours of all elements. Returns "" or an error message.
  std::string build(const VolumeMesh& mesh);

  /// Returns the neighbour across a face (>= 0), or -1 - b if the face is the boundary face with
  /// index b.
  std::int32_t across(std::int32_t element, int face) const
  {
    return this->Across[static_cast<std::size_t>(element)][static_cast<std::size_t>(face)];
  }
  const std::vector<BoundaryFace>& boundary() const { return this->Boundary; }

  /// Return pointers to the first and past the last of the elements that meet at a node.
  const std::int32_t* elementsBegin(std::int32_t node) const
  {
    return this->NodeElements.data() + this->NodeOffset[static_cast<std::size_t>(node)];
  }
  const std::int32_t* elementsEnd(std::int32_t node) const
  {
    return this->NodeElements.data() + this->NodeOffset[static_cast<std::size_t>(node) + 1];
  }

private:
  std::vector<std::array<std::int32_t, 6>> Across;
  std::vector<BoundaryFace> Boundary;
  std::vector<std::size_t> NodeOffset;
  std::vector<std::int32_t> NodeElements;
};

/// Returns the elements that are connected, face by face, to an element with an entirely held face,
/// in ascending order. An element that is connected only by an edge or a corner could rotate about
/// this edge or corner. `held` has one entry per node.
PALPATE_EXPORT std::vector<std::int32_t> elementsHeldByFaces(
  const VolumeMesh& mesh, const MeshTopology& topology, const std::vector<unsigned char>& held);
} // namespace palpate

#endif
