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
  const std::int32_t* triangles = nullptr; ///< three point indices per triangle
  std::size_t triangleCount = 0;
};

/// Returns the mean distance of neighbouring points, mm: the square root of the area per used
/// point. NaN if there are no used points.
double pointSpacing(const TriangleSpans& surface);

/// A surface with the links between its points and facets. Facets without an area are ignored;
/// their corners are -1 and their area is 0.
struct LinkedSurface
{
  /// The arrays that `surface` points to must outlive this object.
  explicit LinkedSurface(const TriangleSpans& surface);

  Eigen::Vector3d place(std::int32_t point) const
  {
    return Eigen::Map<const Eigen::Vector3d>(
      this->spans.points + 3 * static_cast<std::size_t>(point));
  }

  /// Returns the number of points that belong to at least one facet.
  std::size_t usedPoints() const;

  TriangleSpans spans;
  std::vector<TriangleCorners> corners;
  /// Area vectors of the facets: directed along the normal, with the area as length, mm².
  std::vector<Eigen::Vector3d> areas;
  TriangleLinks links;

private:
  /// Finds the corners and areas of the facets.
  const std::vector<TriangleCorners>& findCorners();
};
} // namespace palpate

#endif
