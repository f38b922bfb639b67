// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LinkedSurface_h
#define palpate_LinkedSurface_h

#include "Contact/TriangleLinks.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// A view of a body's triangles. Triangles without an area are ignored.
struct TriangleSpans
{
  const double* points = nullptr; ///< x, y, z of each point, mm
  std::size_t pointCount = 0;
  const std::int32_t* triangles = nullptr; ///< three point indices each
  std::size_t triangleCount = 0;
};

/// The mean distance of neighbouring points, mm: the square root of the area per used point. NaN if
/// there are no used points.
double pointSpacing(const TriangleSpans& surface);

/// A side of a facet, from point to point.
struct SurfaceSide
{
  std::int32_t from;
  std::int32_t to;
  float turn; ///< angle by which the surface turns away at the side, rad; 0: a border
  /// The side has two facets, and its turn is BluntTurn or more (PackedMesh).
  bool isSharp = false;
};

/// A surface with its neighbours. Facets without an area are ignored; their corners are -1 and
/// their area is 0.
struct LinkedSurface
{
  /// The arrays that `surface` points to must outlive this.
  explicit LinkedSurface(const TriangleSpans& surface);

  Eigen::Vector3d place(std::int32_t point) const
  {
    return Eigen::Map<const Eigen::Vector3d>(
      this->spans.points + 3 * static_cast<std::size_t>(point));
  }

  /// Number of points that have a facet.
  std::size_t usedPoints() const;

  TriangleSpans spans;
  std::vector<TriangleCorners> corners;
  std::vector<Eigen::Vector3d> areas; ///< mm², along the normals
  TriangleLinks links;

private:
  /// Also sets `areas`.
  const std::vector<TriangleCorners>& findCorners();
};

/// The border of a surface: sides of a single facet, in loops that are longer than the
/// circumference of a hole with a radius of four contact radii (mm). Two coincident sides are not a
/// border.
std::vector<SurfaceSide> findBorder(const LinkedSurface& surface, double contactRadius);

/// The edges of a surface.
struct SurfaceEdges
{
  static constexpr double LeastTurn = 0.35; ///< rad, 20°

  std::vector<SurfaceSide> sides;
  double cell; ///< size of the cells over which normals of facets were averaged, mm
};

/**
 * Finds the convex edges of a surface for a contact of radius a (mm).
 *
 * Facets are averaged in cells of size a, or of a few facets if the mesh is coarse (FacePatches).
 * Therefore noise of a scan and fine facets are not edges, but a narrow fillet is one. The turn of
 * the surface is measured between neighbouring patches, and over two patches. On a ball the turn
 * continues beyond the patch at the same rate; beyond an edge it does not. If the excess of the
 * turn over that rate is LeastTurn or more, it is the turn of an edge. The edge consists of the
 * facet sides in this region with the largest turns.
 *
 * Cost: O(n log n), 0.5 s for a million triangles on one thread; temporary memory 100 bytes per
 * triangle.
 */
SurfaceEdges findEdges(const LinkedSurface& surface, double contactRadius);

/// Size of the cells over which findEdges() averages facets, mm: the contact radius, or the size of
/// a few facets of a coarse mesh.
double edgeCell(const LinkedSurface& surface, double contactRadius);
} // namespace palpate

#endif
