// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TriangleTree_h
#define palpate_TriangleTree_h

#include "Contact/LargePages.h"
#include "Contact/PackedMesh.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
class NearestTriangle;

/**
 * Finds the closest point of a whole body.
 *
 * A tree of boxes without pointers. The triangles are sorted along a space-filling curve; each box
 * of the lowest level contains the next four triangles, and each box of a higher level the next
 * eight boxes of the level below. Eight boxes are tested at once in float, with a margin for
 * rounding, so that the result is exact for the mesh's coordinates. If several triangles are
 * equally near to the last bit, the one whose boxes are nearer is chosen, compared from the top
 * level down.
 *
 * Queries neither allocate nor recurse; their stack is bounded by the number of levels. Built in
 * O(n) with 7 bytes per triangle. Immutable; can be used from any number of threads. The mesh must
 * outlive the tree.
 */
class PALPATE_EXPORT TriangleTree
{
public:
  explicit TriangleTree(const PackedMesh& mesh);
  TriangleTree(const TriangleTree&) = delete;
  TriangleTree& operator=(const TriangleTree&) = delete;

  /// Returns the globally closest point in the body's frame. The triangle is -1 if the body has no
  /// usable triangle or the tip is not finite. A tip farther away than 10000 times the body's size
  /// is first moved to this distance.
  SurfacePoint closest(const Vector3& tip) const noexcept;

  /// As closest(), in the mesh's local frame.
  SurfacePoint closestLocal(const Vector3& tip) const noexcept;

  /// Returns whether a tip (local coordinates) is farther away than 10000 times the body's size.
  bool isBeyondHorizon(const Vector3& tip) const noexcept
  {
    return tip.cwiseAbs().maxCoeff() > this->Horizon;
  }

  /// Returns the memory used, bytes.
  std::size_t memory() const noexcept;

private:
  friend class TriangleSearch;

  static constexpr std::size_t LeafSize = 4; ///< number of triangles in a box of the lowest level
  static constexpr std::size_t Width = 8;    ///< number of boxes tested at once
  using Row = Eigen::Array<float, Width, 1>;

  /// Eight boxes, stored coordinate by coordinate. Missing boxes are empty.
  struct Boxes
  {
    std::array<Row, 3> low;
    std::array<Row, 3> high;
    void clear();
    /// Returns the squared distance to each box: 0 inside the box, infinite if the box is empty.
    Row squaredDistances(const Eigen::Vector3f& tip) const noexcept
    {
      Row sum = Row::Zero();
      for (std::size_t k = 0; k < 3; ++k)
      {
        const float t = tip[static_cast<Eigen::Index>(k)];
        sum += (this->low[k] - t).max(t - this->high[k]).max(0.0F).square();
      }
      return sum;
    }
  };

  void buildLeaves();
  void buildLevel(const LargeVector<Boxes>& below);
  /// As closestLocal(), for a tip within the horizon.
  SurfacePoint closestWithin(const Vector3& tip) const noexcept;
  /// Checks the triangles of a box of the lowest level. `rounded` is the tip after rounding to
  /// float.
  void searchLeaf(std::size_t leaf, const Vector3& tip, const Eigen::Vector3f& rounded,
    NearestTriangle& nearest) const noexcept;
  /// Returns whether the boxes of a triangle are nearer than the boxes of another triangle.
  bool comesFirst(
    const Eigen::Vector3f& rounded, std::int32_t triangle, std::int32_t other) const noexcept;

  const PackedMesh& Mesh;
  /// The lowest level first; the last level has one row of boxes.
  std::vector<LargeVector<Boxes>> Levels;
  double Size = 0.0;    ///< largest absolute local coordinate of the body
  double Horizon = 0.0; ///< limit of the tip's coordinates, mm; see isBeyondHorizon()
};

/**
 * Finds the closest points of a sequence of tips, each near the preceding one. The results are bit
 * for bit those of TriangleTree::closestLocal, in a fraction of the time.
 *
 * The search walks over the faces from the last closest triangle to the face under the tip. The
 * resulting distance is nearly always the smallest one. The search then checks whether any other
 * triangle is nearer. For this check it stores the boxes of 32 triangles each within Radius of
 * Centre, so that tips in that region need no search from the top of the tree. After a large jump
 * of the tip the whole tree is searched.
 *
 * The search neither allocates nor throws. Each thread needs its own object. Objects may share the
 * tree, which must outlive them.
 */
class PALPATE_EXPORT TriangleSearch
{
public:
  explicit TriangleSearch(const TriangleTree& tree) noexcept
    : Tree(tree)
  {
  }

  /// Returns the globally closest point. The tip and the point are in the mesh's local frame; see
  /// TriangleTree.
  SurfacePoint closestLocal(const Vector3& tip) noexcept;

private:
  static constexpr std::size_t Width = TriangleTree::Width;
  static constexpr std::size_t Capacity = 8 * Width; ///< largest number of stored boxes
  static constexpr int MaximumSteps = 8; ///< largest number of steps of a walk over faces

  struct Place
  {
    std::int32_t triangle;
    TriangleProjection projection;
  };

  /// Returns a triangle near the tip, which is not always the nearest one.
  Place walk(const Vector3& tip) const noexcept;
  /// Returns whether the stored boxes contain all triangles within `reach` of the tip.
  bool isGathered(const Vector3& tip, double reach) const noexcept
  {
    return (tip - this->Centre).norm() + reach <= this->Radius;
  }
  /// Stores the boxes around a tip. Returns false if there are too many boxes.
  bool gather(const Vector3& tip, const Place& near, double reach) noexcept;
  SurfacePoint searchGathered(const Vector3& tip, const Place& near) const noexcept;

  const TriangleTree& Tree;
  std::int32_t Last = -1; ///< closest triangle of the last tip
  Vector3 Centre = Vector3::Zero();
  double Radius = -1.0; ///< mm; negative if no boxes are stored
  std::size_t Count = 0;
  std::array<std::uint32_t, Capacity> Rows; ///< for each box, its row in the tree's lowest level
  std::array<TriangleTree::Boxes, Capacity / Width> Boxes;
};
} // namespace palpate

#endif
