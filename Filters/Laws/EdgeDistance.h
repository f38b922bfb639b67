// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EdgeDistance_h
#define palpate_EdgeDistance_h

#include "Contact/Edges/EdgeLaw.h"
#include "Laws/EdgeSurface.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace palpate
{
/// The nearest edge and the nearest border of a surface, as seen from a point.
struct NearEdge
{
  static constexpr float Far = std::numeric_limits<float>::infinity();
  float distance = Far; ///< distance to the edge along a straight line, mm
  float turn = 0.0F;    ///< angle between the normals on both sides of the edge, rad
  float border = Far;   ///< distance to the border along a straight line, mm
  /// Whether the edge is a single side between two facets with a turn of BluntTurn or more.
  bool isSharp = false;
};

/**
 * For each point of a surface, finds the convex edge that reduces its force most, and the distances
 * from this edge and from the border.
 *
 * findEdges (EdgeSurface.h) defines the edges for a contact of radius a. A distant edge counts only
 * if it is large: beyond four cells the search uses cells that are three times as large, and so on,
 * up to a quarter of the body's width. With large cells, a bump on a face is not an edge, but a
 * wide fillet is.
 *
 * The search runs along the surface up to the distance `reach` (mm). An edge that is seen at more
 * than 15° above the point's tangent plane is ignored, because there is material below such an
 * edge, for example at the foot of a horn.
 *
 * Cost: O(n log n), 1 s for a million triangles on one thread, including 0.3 s for the EdgeSurface.
 * Temporary memory: 60 bytes per triangle and thread. The result is bit for bit the same for any
 * number of threads.
 */
class PALPATE_EXPORT EdgeDistance
{
public:
  EdgeDistance(const TriangleSpans& surface, double contactRadius, double reach);
  /// As above, for a surface that is used for several contact radii.
  EdgeDistance(const EdgeSurface& surface, double contactRadius, double reach);

  const NearEdge& at(std::size_t point) const noexcept { return this->Found[point]; }
  /// Returns the number of facet sides that belong to an edge.
  std::size_t edges() const noexcept { return this->EdgeCount; }

private:
  std::vector<NearEdge> Found;
  std::size_t EdgeCount = 0;
};

/// Returns Φ, the force of a contact of radius a at the distance d = u a of its axis from the
/// straight edge of a wedge, divided by the force far from the edge at the same depth.
/// `distanceOverRadius` is u >= 0. For flat ends, paraboloids and cones Φ is within 0.03 of the
/// result with Hetényi's two half-spaces (Data/Reference/edges). `sharpness` is that of
/// edgeSharpness().
PALPATE_EXPORT double edgeFactor(double poissonRatio, double distanceOverRadius, double sharpness);
} // namespace palpate

#endif
