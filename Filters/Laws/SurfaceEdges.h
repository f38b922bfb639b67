// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceEdges_h
#define palpate_SurfaceEdges_h

#include "Laws/LinkedSurface.h"

#include <vector>

namespace palpate
{
/// The convex edges of a surface.
struct SurfaceEdges
{
  static constexpr double LeastTurn = 0.35; ///< rad, 20°

  std::vector<SurfaceSide> sides;
  double cell; ///< mm, over which facets were averaged
};

/**
 * Finds the convex edges of a surface at the scale of a contact of radius a (mm).
 *
 * Facets are averaged in cells of a, of a coarse mesh of a few facets (long facets are cells of
 * their own), so that neither a scan's noise nor fine facets are edges, but a narrow fillet is.
 * From cell to cell, and over two cells, the surface turns by an angle. The part not explained by
 * the curvature beside it (on a ball the turn continues at the same rate, beyond an edge it does
 * not) is that of the edge, which counts from LeastTurn on. The edge itself lies along the sides of
 * facets that turn most there.
 *
 * Cost: O(n log n), 0.5 s for a million triangles on one thread; 100 bytes a triangle meanwhile.
 */
SurfaceEdges findEdges(const LinkedSurface& surface, double contactRadius);
} // namespace palpate

#endif
