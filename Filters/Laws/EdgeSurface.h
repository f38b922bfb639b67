// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EdgeSurface_h
#define palpate_EdgeSurface_h

#include "Laws/LinkedSurface.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// A side of a facet, from point to point.
struct SurfaceSide
{
  std::int32_t from;
  std::int32_t to;
  float turn; ///< angle by which the surface turns away at the side, rad; 0: a border
  /// The side has two facets, and its turn is BluntTurn or more (PackedMesh).
  bool isSharp = false;
};

/// A surface that is ready for the search of its edges and borders at any contact radius.
struct PALPATE_EXPORT EdgeSurface : LinkedSurface
{
  /// The arrays that `surface` points to must outlive this.
  explicit EdgeSurface(const TriangleSpans& surface);

  /// Whether the surface turns away by PackedMesh::BluntTurn or more at side `i` of a facet.
  bool isSteep(std::size_t facet, std::size_t i) const
  {
    return (this->SteepSides[facet] >> i & 1U) != 0;
  }

  std::vector<Eigen::Vector3d> normals; ///< normals of the points, unit
  double spacing = 0.0;                 ///< square root of the area per point, mm
  /// A width of the body, mm. A box whose surface has the same variances of position has three side
  /// lengths; this is the middle one. It does not depend on the coordinate axes.
  double width = 0.0;
  /// Sides that belong to one facet; two coincident sides are not a border.
  std::vector<SurfaceSide> border;

private:
  /// Also sets `spacing`.
  void findNormals();
  void findSteepSides();

  std::vector<std::uint8_t> SteepSides; ///< one bit for each side of a facet
};

Eigen::Vector3d facetCentre(const LinkedSurface& surface, std::size_t facet);
/// The angle between two facets across side `i` of `facet`, rad; 0 at a border and in a hollow.
double facetTurn(const LinkedSurface& surface, std::size_t facet, std::size_t i);
double angleBetween(const Eigen::Vector3d& one, const Eigen::Vector3d& other);

/// Returns the border of a surface without loops that are shorter than the circumference of a hole
/// with a radius of four times `contactRadius` (mm).
std::vector<SurfaceSide> findBorder(const EdgeSurface& surface, double contactRadius);

/// The edges of a surface.
struct SurfaceEdges
{
  static constexpr double LeastTurn = 0.35; ///< rad, 20°

  std::vector<SurfaceSide> sides;
  double cell; ///< size of the cells over which the normals of facets were averaged, mm
};

/**
 * Finds the convex edges of a surface for a contact of radius a (mm).
 *
 * The normals of facets are averaged in cells of size a, or of a few facets if the mesh is coarse
 * (FacePatches). Therefore noise of a scan and fine facets are not edges, but a narrow fillet is
 * one. The turn of the surface is measured between neighbouring patches, and over two patches. On a
 * ball the turn continues beyond the patch at the same rate; beyond an edge it does not. If the
 * turn exceeds the turn at that rate by LeastTurn or more, it is the turn of an edge. The edge
 * consists of the facet sides in this region with the largest turns.
 *
 * Cost: O(n), 0.3 s for a million triangles on one thread; temporary memory 60 bytes per triangle.
 */
SurfaceEdges findEdges(const EdgeSurface& surface, double contactRadius);

/// Size of the cells over which findEdges() averages facets, mm: the contact radius, or the size of
/// a few facets of a coarse mesh.
double edgeCell(const EdgeSurface& surface, double contactRadius);
} // namespace palpate

#endif
