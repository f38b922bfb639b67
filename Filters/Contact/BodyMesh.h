// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyMesh_h
#define palpate_BodyMesh_h

#include "Mechanics/PalpateExport.h"
#include "Contact/TriangleLinks.h"
#include "Contact/TriangleProjection.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/**
 * The undeformed surface of a body, with the points and triangles in the order of the input.
 * Filters use it to find the triangles that meet at a point, the open borders and the outer side.
 * The servo tick reads the PackedMesh instead.
 *
 * Triangles must be wound counter-clockwise as seen from outside. A triangle is ignored, and
 * counted in defects(), if a vertex is not finite, an index is out of range, or the area is zero.
 *
 * Cost: construction takes O(n) time and about 90 bytes per triangle. The object is immutable and
 * can be used from any number of threads.
 */
class PALPATE_EXPORT BodyMesh
{
public:
  /// Number of triangles with each kind of defect.
  struct Defects
  {
    std::size_t notFinite = 0;
    std::size_t degenerate = 0;
    std::size_t badIndex = 0;
    std::size_t nonManifoldEdges = 0;
    std::size_t borderEdges = 0;
  };

  /// Copies `pointCount` points (x, y, z of each) and `triangleCount` triangles (three point
  /// indices each).
  BodyMesh(const double* points, std::size_t pointCount, const std::int32_t* triangles,
    std::size_t triangleCount);

  /// The arrays given to the constructor: coordinates() has x, y, z of each point, indices() has
  /// three point indices per triangle.
  const double* coordinates() const noexcept { return this->Points.data(); }
  const std::int32_t* indices() const noexcept
  {
    return this->Triangles.empty() ? nullptr : this->Triangles.front().data();
  }
  std::size_t pointCount() const noexcept { return this->Points.size() / 3; }
  std::size_t triangleCount() const noexcept { return this->Triangles.size(); }
  const TriangleCorners& corners(std::int32_t triangle) const noexcept
  {
    return this->Triangles[static_cast<std::size_t>(triangle)];
  }
  Vector3 point(std::int32_t index) const noexcept
  {
    return Eigen::Map<const Vector3>(this->Points.data() + 3 * static_cast<std::size_t>(index));
  }
  /// Returns whether the triangle is usable: it has valid corners and an area.
  bool isUsable(std::int32_t triangle) const noexcept
  {
    return this->Usable[static_cast<std::size_t>(triangle)];
  }
  /// Returns the unit normal at a point: the mean of the normals of its triangles, weighted by
  /// their angles at the point. Zero if no usable triangle meets the point.
  Vector3 pointNormal(std::int32_t index) const noexcept
  {
    return Eigen::Map<const Vector3>(
      this->PointNormals.data() + 3 * static_cast<std::size_t>(index));
  }
  /// Returns the usable triangles around a point as a pointer to the first and a pointer past the
  /// last.
  std::array<const std::int32_t*, 2> trianglesAround(std::int32_t index) const noexcept
  {
    return this->Links->around(index);
  }
  const Defects& defects() const noexcept { return this->Found; }
  bool hasTriangles() const noexcept
  {
    return std::find(this->Usable.begin(), this->Usable.end(), true) != this->Usable.end();
  }
  /// Returns whether the surface encloses a volume. This is the case if it has neither a border nor
  /// a defect.
  bool isClosed() const noexcept;
  /// Returns the volume enclosed by the usable triangles, mm³; negative if the triangles are wound
  /// inward.
  double enclosedVolume() const noexcept;

  /// Returns the point of the triangle closest to the tip; the distance is unsigned.
  TriangleProjection project(const Vector3& tip, std::int32_t triangle) const noexcept;

private:
  void findUsable();
  void computePointNormals();

  std::vector<double> Points;
  std::vector<TriangleCorners> Triangles;
  std::vector<bool> Usable;
  std::shared_ptr<const TriangleLinks> Links; ///< links of the usable triangles
  std::vector<double> PointNormals;
  Defects Found;
};

/// Computes the same normals as pointNormal() without a BodyMesh. Returns x, y, z of each point.
/// Every corner of every triangle must be a valid point index.
PALPATE_EXPORT std::vector<double> angleWeightedNormals(const double* points,
  std::size_t pointCount, const std::int32_t* triangles, std::size_t triangleCount);
} // namespace palpate

#endif
