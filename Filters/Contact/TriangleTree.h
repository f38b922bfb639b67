// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TriangleTree_h
#define palpate_TriangleTree_h

#include "Contact/LargePages.h"
#include "Contact/PackedMesh.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
class NearestTriangle;

/**
 * Finds the closest point of the whole body.
 *
 * A tree of boxes without pointers: the triangles lie along a space-filling curve, so each box of
 * the lowest level holds the next four of them, and each box of a higher level the next eight boxes
 * below. Eight boxes are tested at once, in float with a margin for its rounding, so that the
 * answer is exact in the mesh's coordinates. Of triangles equally near, to the last bit, it takes
 * the one whose boxes are nearer, from the top down.
 *
 * Queries neither allocate nor recurse; their stack is bounded by the number of levels. Built in
 * O(n), 7 bytes per triangle. Immutable, safe from any number of threads. The mesh must outlive the
 * tree.
 */
class PALPATE_EXPORT TriangleTree
{
public:
  explicit TriangleTree(const PackedMesh& mesh);
  /// A copy of the tree of an equal mesh, for this one.
  TriangleTree(const TriangleTree& equal, const PackedMesh& mesh)
    : Mesh(mesh)
    , Levels(equal.Levels)
    , Size(equal.Size)
    , Horizon(equal.Horizon)
  {
  }
  TriangleTree(const TriangleTree&) = delete;
  TriangleTree& operator=(const TriangleTree&) = delete;

  /// Globally closest point, in the body's frame; triangle -1 if the body has no usable triangle or
  /// the tip is not finite. For a tip farther off than 10000 times the body's size the point that
  /// is closest seen from there.
  SurfacePoint closest(const Vector3& tip) const noexcept;

  /// The same in the mesh's local frame.
  SurfacePoint closestLocal(const Vector3& tip) const noexcept;

  /// Whether a tip, local, is that far off.
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

  /// Eight boxes, coordinate by coordinate; those that are missing are empty.
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
  /// Of a tip within the horizon.
  SurfacePoint closestWithin(const Vector3& tip) const noexcept;
  /// Looks at the triangles of a box of the lowest level. `rounded`: the tip in floats.
  void searchLeaf(std::size_t leaf, const Vector3& tip, const Eigen::Vector3f& rounded,
    NearestTriangle& nearest) const noexcept;
  /// Whether the boxes of a triangle are nearer than those of another.
  bool comesFirst(
    const Eigen::Vector3f& rounded, std::int32_t triangle, std::int32_t other) const noexcept;

  const PackedMesh& Mesh;
  std::vector<LargeVector<Boxes>> Levels; ///< from the leaves up; the last has one row of boxes
  double Size = 0.0;                      ///< largest coordinate of the body, local
  double Horizon = 0.0; ///< coordinates of tips beyond which nothing more is to be seen
};
} // namespace palpate

#endif
