// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EdgeDistance_h
#define palpate_EdgeDistance_h

#include "Laws/TriangleSpans.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace palpate
{
/// The edge of a surface next to a point, and its border.
struct NearEdge
{
  static constexpr float Far = std::numeric_limits<float>::infinity();
  float distance = Far; ///< mm, straight
  float turn = 0.0F;    ///< by which the surface turns away there, rad
  float border = Far;   ///< mm, straight, to where the surface ends
};

/**
 * How far each point of a surface is from the next edge where it turns away (convex), and from
 * where it ends.
 *
 * An edge is what a contact of radius a takes for one. Facets are averaged in cells of a, of a
 * coarse mesh of a few facets (long facets stand for themselves), so that neither a scan's noise
 * nor fine facets are edges, and a narrow fillet is one. From cell to cell, and over two, the
 * surface turns by an angle; what of it its own curvature beside does not explain (the turn goes on
 * at the same rate on a ball, and does not beyond an edge) is the edge's. From `LeastTurn` on it
 * counts. An open border counts where it is longer than a hole of 4 a; edges that lie twice at the
 * same place are none.
 *
 * The edge itself lies along the facets' sides that turn most there; points look for the nearest
 * along the surface, no farther than `reach`.
 *
 * Cost: O(n log n), 0.5 to 1 s for a million triangles on one thread; 100 bytes a triangle while it
 * is made. The same for any number of threads.
 */
class PALPATE_EXPORT EdgeDistance
{
public:
  static constexpr double LeastTurn = 0.35; ///< rad, 20°

  /// `isSeam`, if not null, is nonzero at points where the surface goes on elsewhere: no border.
  EdgeDistance(const TriangleSpans& surface, double contactRadius, double reach,
    const unsigned char* isSeam = nullptr);

  const NearEdge& at(std::size_t point) const noexcept { return this->Found[point]; }
  /// Sides of facets that are edges, and borders.
  std::size_t edges() const noexcept { return this->EdgeCount; }

private:
  std::vector<NearEdge> Found;
  std::size_t EdgeCount = 0;
};

/// Φ of a contact of radius a whose axis is u = d/a from the straight edge of a quarter space: its
/// force over that far from the edge, at the same depth. u >= 0; for flats, paraboloids and cones
/// within 0.02 of Hetényi's two half-spaces (Data/Reference/edges).
PALPATE_EXPORT double edgeFactor(double poissonsRatio, double distanceOverRadius);
} // namespace palpate

#endif
