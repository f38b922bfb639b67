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
  bool isSharp = false; ///< two facets turn so, by no less than PackedMesh::BluntTurn
};

/// A surface and what lies beside what. Facets without an area take no part: corners -1, area 0.
struct LinkedSurface
{
  /// What `surface` points to must outlive this.
  explicit LinkedSurface(const TriangleSpans& surface);

  Eigen::Vector3d place(std::int32_t point) const
  {
    return Eigen::Map<const Eigen::Vector3d>(
      this->spans.points + 3 * static_cast<std::size_t>(point));
  }

  TriangleSpans spans;
  std::vector<TriangleCorners> corners;
  std::vector<Eigen::Vector3d> areas; ///< mm², along the normals
  TriangleLinks links;

private:
  /// And areas.
  const std::vector<TriangleCorners>& findCorners();
};

/// Where a surface ends: sides of one facet, in loops longer than a hole of four contact radii
/// (mm); sides that lie twice at the same place are none.
std::vector<SurfaceSide> findBorder(const LinkedSurface& surface, double contactRadius);
} // namespace palpate

#endif
