// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LinkedSurface_h
#define palpate_LinkedSurface_h

#include "Contact/TriangleLinks.h"
#include "Laws/TriangleSpans.h"

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
} // namespace palpate

#endif
