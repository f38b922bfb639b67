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
 * The undeformed surface of a body in the order and with the coordinates of its input, for filters
 * that traverse it: the triangles that meet at a point, open borders, the outer side. The servo
 * tick reads the PackedMesh instead.
 *
 * Triangles are wound counter-clockwise seen from outside. A triangle is ignored, and counted in
 * defects(), if a vertex is not finite, an index is out of range, or the area is zero.
 *
 * Cost: built in O(n), about 90 bytes per triangle. Immutable, safe from any number of threads.
 */
class PALPATE_EXPORT BodyMesh
{
public:
  /// Counts of the defects of the triangles.
  struct Defects
  {
    std::size_t notFinite = 0;
    std::size_t degenerate = 0;
    std::size_t badIndex = 0;
    std::size_t nonManifoldEdges = 0;
    std::size_t borderEdges = 0;
  };

  /// Copies `pointCount` points (x, y, z) and `triangleCount` triangles (three point indices).
  BodyMesh(const double* points, std::size_t pointCount, const std::int32_t* triangles,
    std::size_t triangleCount);

  /// The arrays given to the constructor: x, y, z of each point; three indices of each triangle.
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
  /// Whether the triangle is used in contact.
  bool isUsable(std::int32_t triangle) const noexcept
  {
    return this->Usable[static_cast<std::size_t>(triangle)];
  }
  /// Unit angle-weighted normal at a point; zero if no usable triangle meets the point.
  Vector3 pointNormal(std::int32_t index) const noexcept
  {
    return Eigen::Map<const Vector3>(
      this->PointNormals.data() + 3 * static_cast<std::size_t>(index));
  }
  /// The usable triangles around a point: first and one past the last.
  std::array<const std::int32_t*, 2> trianglesAround(std::int32_t index) const noexcept
  {
    return this->Links->around(index);
  }
  const Defects& defects() const noexcept { return this->Found; }
  bool hasTriangles() const noexcept
  {
    return std::find(this->Usable.begin(), this->Usable.end(), true) != this->Usable.end();
  }
  /// Whether the surface encloses a volume: it has neither a border nor a defect.
  bool isClosed() const noexcept;
  /// Volume enclosed by the usable triangles, mm³; negative if they are wound inward.
  double enclosedVolume() const noexcept;

  /// The point of the triangle closest to the tip; the distance is unsigned.
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

/// Computes the same normals as pointNormal() without a BodyMesh: x, y, z of each point. Every
/// corner of every triangle must be the index of a point.
PALPATE_EXPORT std::vector<double> angleWeightedNormals(const double* points,
  std::size_t pointCount, const std::int32_t* triangles, std::size_t triangleCount);
} // namespace palpate

#endif
