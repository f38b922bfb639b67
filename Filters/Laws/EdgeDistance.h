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
/// The edge of a surface that is nearest to a point, and the nearest border.
struct NearEdge
{
  static constexpr float Far = std::numeric_limits<float>::infinity();
  float distance = Far; ///< mm, straight line
  float turn = 0.0F;    ///< angle by which the surface turns away there, rad
  float border = Far;   ///< distance to the border, mm, straight line
  bool isSharp = false; ///< the edge is a side between two facets that turn by BluntTurn or more
};

/**
 * Distances of each point of a surface from two things: the convex edge that reduces its force
 * most, and the border.
 *
 * findEdges (LinkedSurface.h) defines the edges for a contact of radius a. Distant edges must be
 * larger to count: beyond four cells the search uses cells three times as large, and so on, up to a
 * quarter of the body's width. At that size a bump on a face is not an edge, but a wide fillet is.
 *
 * The search runs along the surface up to the distance `reach`. It skips an edge more than 15°
 * above the point's tangent plane, because there is material below such an edge, as at the foot of
 * a horn.
 *
 * Cost: O(n log n), 1 to 3 s for a million triangles on one thread; temporary memory 100 bytes per
 * triangle and thread. The bits do not depend on the number of threads.
 */
class PALPATE_EXPORT EdgeDistance
{
public:
  EdgeDistance(const TriangleSpans& surface, double contactRadius, double reach);

  const NearEdge& at(std::size_t point) const noexcept { return this->Found[point]; }
  /// Number of facet sides that belong to an edge.
  std::size_t edges() const noexcept { return this->EdgeCount; }

private:
  std::vector<NearEdge> Found;
  std::size_t EdgeCount = 0;
};

/// Φ of a contact of radius a whose axis is at u = d/a from the straight edge of a wedge: its force
/// divided by the force far from the edge at the same depth. u >= 0. For flats, paraboloids and
/// cones it is within 0.03 of Hetényi's two half-spaces (Data/Reference/edges). Other angles are
/// taken into account by their sharpness.
PALPATE_EXPORT double edgeFactor(double poissonsRatio, double distanceOverRadius, double sharpness);
} // namespace palpate

#endif
