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
/// A side of a facet, from one point to another.
struct SurfaceSide
{
  std::int32_t from;
  std::int32_t to;
  float turn; ///< angle between the normals of the two facets, rad; 0 at a border
  /// Whether the side has two facets and a turn of BluntTurn or more (PackedMesh).
  bool isSharp = false;
};

/// A surface prepared for the search of its edges and borders at any contact radius.
struct PALPATE_EXPORT EdgeSurface : LinkedSurface
{
  /// The arrays that `surface` points to must outlive this object.
  explicit EdgeSurface(const TriangleSpans& surface);

  /// Returns whether the surface turns away by at least PackedMesh::BluntTurn at side `i` of a
  /// facet.
  bool isSteep(std::size_t facet, std::size_t i) const
  {
    return (this->SteepSides[facet] >> i & 1U) != 0;
  }

  std::vector<Eigen::Vector3d> normals; ///< unit normals of the points
  double spacing = 0.0;                 ///< square root of the area per point, mm
  /// A width of the body, mm. It is the middle one of the three side lengths of a box whose surface
  /// has the same variances of position as the body's surface. It does not depend on the coordinate
  /// axes.
  double width = 0.0;
  /// Sides that belong to only one facet. Two coincident sides are not a border.
  std::vector<SurfaceSide> border;

private:
  /// Computes the normals of the points, and `spacing`.
  void findNormals();
  void findSteepSides();

  std::vector<std::uint8_t> SteepSides; ///< one bit for each side of a facet
};

Eigen::Vector3d facetCentre(const LinkedSurface& surface, std::size_t facet);
/// Returns the angle between the normals of two facets across side `i` of `facet`, rad; 0 at a
/// border and at a concave side.
double facetTurn(const LinkedSurface& surface, std::size_t facet, std::size_t i);
double angleBetween(const Eigen::Vector3d& one, const Eigen::Vector3d& other);

/// Returns the border of a surface. Loops shorter than the circumference of a circle with a radius
/// of four times `contactRadius` (mm) are left out.
std::vector<SurfaceSide> findBorder(const EdgeSurface& surface, double contactRadius);

/// The edges of a surface.
struct SurfaceEdges
{
  static constexpr double LeastTurn = 0.35; ///< rad (20°)

  std::vector<SurfaceSide> sides;
  double cell; ///< size of the cells over which the normals of facets were averaged, mm
};

/**
 * Finds the convex edges of a surface for a contact of radius a (mm).
 *
 * The normals of facets are averaged in cells of size a, or of the size of a few facets if the mesh
 * is coarse (FacePatches). Therefore the noise of a scan and fine facets are not edges, but a
 * narrow fillet is an edge. The angle by which the surface turns is measured between neighbouring
 * patches, and over two patches. On a sphere the surface continues to turn beyond the patch at the
 * same rate; beyond an edge it does not. If the angle exceeds the angle at that rate by LeastTurn
 * or more, there is an edge with this angle. The edge consists of the facet sides in this region
 * with the largest angles.
 *
 * Cost: O(n), 0.3 s for a million triangles on one thread; temporary memory 60 bytes per triangle.
 */
SurfaceEdges findEdges(const EdgeSurface& surface, double contactRadius);

/// Returns the size of the cells in which findEdges() averages the normals of facets, mm: the
/// contact radius, or the size of a few facets of a coarse mesh.
double edgeCell(const EdgeSurface& surface, double contactRadius);
} // namespace palpate

#endif
