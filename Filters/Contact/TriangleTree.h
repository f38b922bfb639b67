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
 * Finds the closest point of the whole body.
 *
 * A tree of boxes without pointers: the triangles are sorted along a space-filling curve, so that
 * each box of the lowest level contains the next four triangles, and each box of a higher level the
 * next eight boxes below. Eight boxes are tested at once, in float with a margin for its rounding,
 * so that the result is exact in the mesh's coordinates. If triangles are equally near to the last
 * bit, the one whose boxes are nearer is chosen, from the top level down.
 *
 * Queries neither allocate nor recurse; their stack is bounded by the number of levels. Built in
 * O(n), 7 bytes per triangle. Immutable, safe from any number of threads. The mesh must outlive the
 * tree.
 */
class PALPATE_EXPORT TriangleTree
{
public:
  explicit TriangleTree(const PackedMesh& mesh);
  TriangleTree(const TriangleTree&) = delete;
  TriangleTree& operator=(const TriangleTree&) = delete;

  /// Globally closest point, in the body's frame. The triangle is -1 if the body has no usable
  /// triangle or the tip is not finite. If the tip is farther away than 10000 times the body's
  /// size, the result is that of a tip moved to this distance.
  SurfacePoint closest(const Vector3& tip) const noexcept;

  /// As closest(), in the mesh's local frame.
  SurfacePoint closestLocal(const Vector3& tip) const noexcept;

  /// Whether a tip (local) is farther away than 10000 times the body's size.
  bool isBeyondHorizon(const Vector3& tip) const noexcept
  {
    return tip.cwiseAbs().maxCoeff() > this->Horizon;
  }

  /// Bytes held.
  std::size_t memory() const noexcept;

private:
  friend class TriangleSearch;

  static constexpr std::size_t LeafSize = 4; ///< triangles in a box of the lowest level
  static constexpr std::size_t Width = 8;    ///< boxes tested at once
  using Row = Eigen::Array<float, Width, 1>;

  /// Eight boxes, coordinate by coordinate; missing boxes are empty.
  struct Boxes
  {
    std::array<Row, 3> low;
    std::array<Row, 3> high;
    void clear();
    /// Squared distance to each box; 0 inside, infinite if it is empty.
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
  /// Checks the triangles of a box of the lowest level. `rounded` is the tip in floats.
  void searchLeaf(std::size_t leaf, const Vector3& tip, const Eigen::Vector3f& rounded,
    NearestTriangle& nearest) const noexcept;
  /// Whether the boxes of a triangle are nearer than those of another one.
  bool comesFirst(
    const Eigen::Vector3f& rounded, std::int32_t triangle, std::int32_t other) const noexcept;

  const PackedMesh& Mesh;
  std::vector<LargeVector<Boxes>> Levels; ///< the leaves first; the last has one row of boxes
  double Size = 0.0;                      ///< largest coordinate of the body, local
  double Horizon = 0.0;                   ///< limit of tip coordinates, see isBeyondHorizon()
};

/**
 * Closest points of a sequence of tips, each near the preceding one. The results are those of
 * TriangleTree::closestLocal, bit for bit, in a fraction of the time.
 *
 * The search walks over the faces from the last closest triangle to the face under the tip. The
 * resulting distance is nearly always the correct one; the search then checks whether any triangle
 * is nearer. For this check it stores the boxes of 32 triangles each within Radius of Centre, so
 * that tips in that region need no search from the top of the tree. After a large jump of the tip
 * the whole tree is searched.
 *
 * Neither allocates nor throws. One search serves one thread; the tree may be shared and must
 * outlive it.
 */
class PALPATE_EXPORT TriangleSearch
{
public:
  explicit TriangleSearch(const TriangleTree& tree) noexcept
    : Tree(tree)
  {
  }

  /// Globally closest point, tip and point in the mesh's local frame; see TriangleTree.
  SurfacePoint closestLocal(const Vector3& tip) noexcept;

private:
  static constexpr std::size_t Width = TriangleTree::Width;
  static constexpr std::size_t Capacity = 8 * Width; ///< boxes stored
  static constexpr int MaximumSteps = 8; ///< largest number of steps of a walk over faces

  struct Place
  {
    std::int32_t triangle;
    TriangleProjection projection;
  };

  /// A triangle near the tip, but not always the nearest.
  Place walk(const Vector3& tip) const noexcept;
  /// Whether the stored boxes contain all triangles within `reach` of the tip.
  bool isGathered(const Vector3& tip, double reach) const noexcept
  {
    return (tip - this->Centre).norm() + reach <= this->Radius;
  }
  /// Stores the boxes around a tip; returns false if there are too many.
  bool gather(const Vector3& tip, const Place& near, double reach) noexcept;
  SurfacePoint searchGathered(const Vector3& tip, const Place& near) const noexcept;

  const TriangleTree& Tree;
  std::int32_t Last = -1; ///< closest triangle of the last tip
  Vector3 Centre = Vector3::Zero();
  double Radius = -1.0; ///< mm; < 0: no boxes are stored
  std::size_t Count = 0;
  std::array<std::uint32_t, Capacity> Rows; ///< row of the tree's lowest level, for each box
  std::array<TriangleTree::Boxes, Capacity / Width> Boxes;
};
} // namespace palpate

#endif
