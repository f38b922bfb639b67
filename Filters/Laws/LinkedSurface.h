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
/// A body's triangles as they lie in memory; those without an area take no part.
struct TriangleSpans
{
  const double* points = nullptr; ///< x, y, z of each, mm
  std::size_t pointCount = 0;
  const std::int32_t* triangles = nullptr; ///< three points each
  std::size_t triangleCount = 0;
};

/// A side of a facet, from point to point.
struct SurfaceSide
{
  std::int32_t from;
  std::int32_t to;
  float turn;           ///< by which the surface turns away there, rad; 0: a border
  bool isSharp = false; ///< a side of two facets that turns by PackedMesh::BluntTurn or more
};

/// A surface with its neighbours. Facets without an area are ignored: corners -1, area 0.
struct LinkedSurface
{
  /// What `surface` points to must outlive this.
  explicit LinkedSurface(const TriangleSpans& surface);

  Eigen::Vector3d place(std::int32_t point) const
  {
    return Eigen::Map<const Eigen::Vector3d>(
      this->spans.points + 3 * static_cast<std::size_t>(point));
  }

  /// How many points have a facet.
  std::size_t usedPoints() const;

  TriangleSpans spans;
  std::vector<TriangleCorners> corners;
  std::vector<Eigen::Vector3d> areas; ///< mm², along the normals
  TriangleLinks links;

private:
  /// And areas.
  const std::vector<TriangleCorners>& findCorners();
};

/// The border of a surface: sides of a single facet, in loops longer than a hole of four contact
/// radii (mm); two sides at the same place are not a border.
std::vector<SurfaceSide> findBorder(const LinkedSurface& surface, double contactRadius);

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
 * Facets are averaged in cells of a, of a coarse mesh of a few facets (FacePatches), so that
 * neither a scan's noise nor fine facets are edges, and a narrow fillet is one. From patch to
 * patch, and over two, the surface turns by an angle. On a ball the turn goes on at the same rate;
 * beyond an edge it does not. The excess is the turn of an edge, if it is LeastTurn or more. The
 * edge lies along the sides of facets that turn most there.
 *
 * Cost: O(n log n), 0.5 s for a million triangles on one thread; 100 bytes a triangle while they
 * are found.
 */
SurfaceEdges findEdges(const LinkedSurface& surface, double contactRadius);

/// Size of the cells over which findEdges() averages facets, mm: the contact radius, or a few
/// facets of a coarse mesh.
double edgeCell(const LinkedSurface& surface, double contactRadius);
} // namespace palpate

#endif
