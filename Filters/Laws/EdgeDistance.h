// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EdgeDistance_h
#define palpate_EdgeDistance_h

#include "Contact/Edges/EdgeLaw.h"
#include "Laws/LinkedSurface.h"
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
  bool isSharp = false; ///< the edge lies between two facets, and is none of BluntTurn
};

/**
 * How far each point of a surface is from the edge where it turns away (convex) that takes most of
 * its force, and from where the surface ends.
 *
 * What is an edge for a contact of radius a: SurfaceEdges.h. Seen from afar it takes more: what
 * lies farther than four cells is looked for with cells three times as large, and so on, up to a
 * quarter of the body's width, beyond which the last ones do; a bump on a face is no edge from
 * there, a wide fillet is one.
 *
 * Points look along the surface, no farther than `reach`, and not where an edge rises above their
 * own tangent plane by more than 15°: there is body below it, as at the foot of a horn.
 *
 * Cost: O(n log n), 1 to 3 s for a million triangles on one thread; 100 bytes a triangle while it
 * is made. The same for any number of threads.
 */
class PALPATE_EXPORT EdgeDistance
{
public:
  EdgeDistance(const TriangleSpans& surface, double contactRadius, double reach);

  const NearEdge& at(std::size_t point) const noexcept { return this->Found[point]; }
  /// Sides of facets that are edges.
  std::size_t edges() const noexcept { return this->EdgeCount; }

private:
  std::vector<NearEdge> Found;
  std::size_t EdgeCount = 0;
};

/// Φ of a contact of radius a whose axis is u = d/a from the straight edge of a wedge: its force
/// over that far from the edge, at the same depth. u >= 0; for flats, paraboloids and cones within
/// 0.03 of Hetényi's two half-spaces (Data/Reference/edges), for other angles with their sharpness.
PALPATE_EXPORT double edgeFactor(double poissonsRatio, double distanceOverRadius, double sharpness);
} // namespace palpate

#endif
