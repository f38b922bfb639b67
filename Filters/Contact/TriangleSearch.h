// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TriangleSearch_h
#define palpate_TriangleSearch_h

#include "Mechanics/PalpateExport.h"
#include "Contact/TriangleTree.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/**
 * Closest points of tips that come one after another, each near the last: the same as
 * TriangleTree::closestLocal, to the bit, in a fraction of its time.
 *
 * From the last closest triangle it walks over the faces to under the tip, which gives a distance
 * that is nearly always the right one; then it looks whether anything is nearer. For that it keeps
 * at hand the boxes of 32 triangles each within Radius of Centre, so that the tree is not entered
 * from the top for tips around there. A tip that leaps is searched for in the whole tree.
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
  static constexpr std::size_t Capacity = 8 * Width; ///< boxes at hand
  static constexpr int MaximumSteps = 8;             ///< of a walk over faces

  struct Place
  {
    std::int32_t triangle;
    TriangleProjection projection;
  };

  /// A triangle near the tip, if not the nearest.
  Place walk(const Vector3& tip) const noexcept;
  /// Whether all that is within `reach` of the tip is in a box at hand.
  bool isAtHand(const Vector3& tip, double reach) const noexcept
  {
    return (tip - this->Centre).norm() + reach <= this->Radius;
  }
  /// Takes the boxes around a tip at hand; false if they are too many.
  bool gather(const Vector3& tip, const Place& near, double reach) noexcept;
  SurfacePoint searchAtHand(const Vector3& tip, const Place& near) const noexcept;

  const TriangleTree& Tree;
  std::int32_t Last = -1; ///< closest triangle of the last tip
  Vector3 Centre = Vector3::Zero();
  double Radius = -1.0; ///< mm; < 0: nothing is at hand
  std::size_t Count = 0;
  std::array<std::uint32_t, Capacity> Rows; ///< of the tree's lowest level, of each box
  std::array<TriangleTree::Boxes, Capacity / Width> Boxes;
};
} // namespace palpate

#endif
