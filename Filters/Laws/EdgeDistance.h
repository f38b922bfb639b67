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
  float border = Far;   ///< mm, straight, to the border
  bool isSharp = false; ///< the edge is a side between two facets that turn by BluntTurn or more
};

/**
 * Distances of each point of a surface from the convex edge that reduces its force most, and from
 * the border.
 *
 * What is an edge for a contact of radius a: SurfaceEdges.h. Farther edges must be larger: beyond
 * four cells they are searched with cells three times as large, and so on, up to a quarter of the
 * body's width; from there a bump on a face is not an edge, but a wide fillet is.
 *
 * The search runs along the surface, no farther than `reach`, and skips an edge more than 15° above
 * the point's tangent plane: there is body below it, as at the foot of a horn.
 *
 * Cost: O(n log n), 1 to 3 s for a million triangles on one thread; 100 bytes a triangle and thread
 * meanwhile.
 * The same bits for any number of threads.
 */
class PALPATE_EXPORT EdgeDistance
{
public:
  EdgeDistance(const TriangleSpans& surface, double contactRadius, double reach);

  const NearEdge& at(std::size_t point) const noexcept { return this->Found[point]; }
  /// Number of facet sides that are edges.
  std::size_t edges() const noexcept { return this->EdgeCount; }

private:
  std::vector<NearEdge> Found;
  std::size_t EdgeCount = 0;
};

/// Φ of a contact of radius a whose axis is u = d/a from the straight edge of a wedge: its force
/// relative to that far from the edge, at the same depth. u >= 0; for flats, paraboloids and cones
/// within 0.03 of Hetényi's two half-spaces (Data/Reference/edges), for other angles by their
/// sharpness.
PALPATE_EXPORT double edgeFactor(double poissonsRatio, double distanceOverRadius, double sharpness);
} // namespace palpate

#endif
