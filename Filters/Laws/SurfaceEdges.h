// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceEdges_h
#define palpate_SurfaceEdges_h

#include "Laws/LinkedSurface.h"

#include <vector>

namespace palpate
{
/// Where a surface turns away.
struct SurfaceEdges
{
  static constexpr double LeastTurn = 0.35; ///< rad, 20°

  std::vector<SurfaceSide> sides;
  double cell; ///< mm, over which facets were averaged
};

/**
 * What a contact of radius a (mm) takes for an edge of a surface, where it turns away (convex).
 *
 * Facets are averaged in cells of a, of a coarse mesh of a few facets (long facets stand for
 * themselves), so that neither a scan's noise nor fine facets are edges, and a narrow fillet is
 * one. From cell to cell, and over two, the surface turns by an angle; what of it its own curvature
 * beside does not explain (the turn goes on at the same rate on a ball, and does not beyond an
 * edge) is the edge's. From LeastTurn on it counts. The edge itself lies along the facets' sides
 * that turn most there.
 *
 * Cost: O(n log n), 0.5 s for a million triangles on one thread; 100 bytes a triangle while they
 * are found.
 */
SurfaceEdges findEdges(const LinkedSurface& surface, double contactRadius);
} // namespace palpate

#endif
