// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TriangleLinks_h
#define palpate_TriangleLinks_h

#include "Contact/TriangleProjection.h"
#include "Mechanics/PalpateExport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/**
 * The triangles that meet at each point and across each edge. Edge i of a triangle runs from its
 * corner i to its corner i + 1 (mod 3).
 *
 * Two triangles are neighbours if no other triangle shares their edge and they are wound
 * consistently, that is, in opposite directions along the edge. An edge with one triangle is a
 * border. An edge with more than two triangles, or with two of opposite winding, is not manifold
 * and has no neighbours either. Triangles whose first corner is negative are ignored. The corners
 * of all other triangles must be valid point indices.
 *
 * Cost: O(n); threaded; the result does not depend on the number of threads.
 */
class PALPATE_EXPORT TriangleLinks
{
public:
  static constexpr std::int32_t Border = -1;
  static constexpr std::int32_t NonManifold = -2;

  TriangleLinks(const std::vector<TriangleCorners>& triangles, std::size_t pointCount);

  /// Returns the triangle across each edge, or Border or NonManifold.
  const std::array<std::int32_t, 3>& neighbours(std::size_t triangle) const noexcept
  {
    return this->Neighbours[triangle];
  }
  /// Returns the triangles around a point, in ascending order, as a pointer to the first and a
  /// pointer past the last.
  std::array<const std::int32_t*, 2> around(std::int32_t point) const noexcept
  {
    const auto i = static_cast<std::size_t>(point);
    return { this->Ring.data() + this->RingStart[i], this->Ring.data() + this->RingStart[i + 1] };
  }
  /// Returns whether an edge without neighbour ends at the point.
  bool onBorder(std::int32_t point) const noexcept
  {
    return this->OnBorder[static_cast<std::size_t>(point)] != 0;
  }
  std::size_t borderEdges() const noexcept { return this->BorderEdges; }
  std::size_t nonManifoldEdges() const noexcept { return this->NonManifoldEdges; }
  /// Number of non-manifold edges with exactly two triangles. Reversing one of the triangles would
  /// repair such an edge.
  std::size_t twistedEdges() const noexcept { return this->TwistedEdges; }

private:
  void linkPoints(const std::vector<TriangleCorners>& triangles, std::size_t pointCount);
  void linkEdges(const std::vector<TriangleCorners>& triangles);
  void markBorder(const std::vector<TriangleCorners>& triangles, std::size_t pointCount);

  std::vector<std::array<std::int32_t, 3>> Neighbours;
  std::vector<std::uint32_t> RingStart;
  std::vector<std::int32_t> Ring;
  std::vector<std::uint8_t> OnBorder;
  std::size_t BorderEdges = 0;
  std::size_t NonManifoldEdges = 0;
  std::size_t TwistedEdges = 0;
};
} // namespace palpate

#endif
