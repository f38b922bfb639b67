// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceEdges_h
#define palpate_SurfaceEdges_h

#include "Contact/TriangleLinks.h"
#include "Laws/TriangleSpans.h"
#include "Mechanics/PalpateExport.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// A surface and what lies beside what. Triangles without an area take no part: corners -1.
struct LinkedSurface
{
  /// What `surface` points to must outlive this.
  explicit LinkedSurface(const TriangleSpans& surface);

  TriangleSpans spans;
  std::vector<TriangleCorners> corners;
  TriangleLinks links;
};

/// A side of a facet that is an edge of the surface, or its border.
struct SurfaceSide
{
  std::int32_t from;
  std::int32_t to;
  float turn; ///< by which the surface turns away there, rad; 0: a border
};

/// What turns away on a surface, and where it ends.
struct SurfaceEdges
{
  static constexpr double LeastTurn = 0.35; ///< rad, 20°

  std::vector<SurfaceSide> sides;
  std::vector<SurfaceSide> border;
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
 * An open border counts where it is longer than a hole of 4 a; sides that lie twice at the same
 * place are none.
 *
 * Cost: O(n log n), 0.5 s for a million triangles on one thread; 100 bytes a triangle while they
 * are found.
 */
SurfaceEdges findEdges(const LinkedSurface& surface, double contactRadius);
} // namespace palpate

#endif
