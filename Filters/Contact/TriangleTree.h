// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TriangleTree_h
#define palpate_TriangleTree_h

#include "BodyMesh.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace palpate
{
/**
 * Finds the closest point of the whole body: a binary tree of boxes, split at the median.
 *
 * Queries neither allocate nor recurse; their stack is bounded by the depth of the tree, which is
 * at most log2 of the number of triangles plus one. Built in O(n log n). Immutable, safe from any
 * number of threads. The mesh must outlive the tree.
 */
class TriangleTree
{
public:
  explicit TriangleTree(const BodyMesh& mesh);

  /// Globally closest point; triangle -1 if the body has no usable triangle or the tip is not
  /// finite.
  SurfacePoint closest(const Vector3& tip) const noexcept;

private:
  struct Node
  {
    Eigen::AlignedBox3d box;
    std::int32_t first; ///< of a leaf's triangles; of an inner node's right child (left is next)
    std::int32_t count; ///< 0 for an inner node
  };

  std::int32_t build(std::int32_t first, std::int32_t last, const std::vector<Vector3>& centres);

  const BodyMesh& Mesh;
  std::vector<Node> Nodes;
  std::vector<std::int32_t> Order;
};
} // namespace palpate

#endif
