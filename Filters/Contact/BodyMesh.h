// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyMesh_h
#define palpate_BodyMesh_h

#include "TriangleProjection.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// A closest point of the body: its triangle (-1: none), where on it, and on which side the tip is.
struct SurfacePoint
{
  std::int32_t triangle = -1;
  TriangleProjection projection;
  /// Distance from the surface to the tip, mm: > 0 outside, < 0 inside.
  double signedDistance = 0.0;
  /// The closest point lies on an open border, where inside and outside are not defined.
  bool onBorder = false;
};

/**
 * The undeformed surface of a body: triangles, their neighbours, and which way is out.
 *
 * Triangles wind counter-clockwise seen from outside. The side of a tip is the sign of its offset
 * along the angle-weighted pseudonormal of the closest feature - face, edge or corner - which is
 * right for the closest point of any closed 2-manifold (Baerentzen and Aanaes 2005).
 *
 * Triangles with a vertex that is not finite, an index out of range or no area take no part in
 * contact; they are counted. An edge shared by more than two triangles, or by two of opposite
 * winding, has no neighbour across and counts as border.
 *
 * Cost: built in O(n), about 110 bytes per triangle. Immutable, safe from any number of threads.
 */
class BodyMesh
{
public:
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

  std::size_t pointCount() const noexcept { return this->Points.size() / 3; }
  std::size_t triangleCount() const noexcept { return this->Triangles.size(); }
  const std::array<std::int32_t, 3>& corners(std::int32_t triangle) const noexcept
  {
    return this->Triangles[static_cast<std::size_t>(triangle)];
  }
  Vector3 point(std::int32_t index) const noexcept
  {
    return Eigen::Map<const Vector3>(this->Points.data() + 3 * static_cast<std::size_t>(index));
  }
  /// Whether the triangle takes part in contact.
  bool isUsable(std::int32_t triangle) const noexcept
  {
    return this->Neighbours[static_cast<std::size_t>(triangle)][0] != Unusable;
  }
  /// Unit angle-weighted normal at a point; zero where no usable triangle meets.
  Vector3 pointNormal(std::int32_t index) const noexcept
  {
    return Eigen::Map<const Vector3>(
      this->PointNormals.data() + 3 * static_cast<std::size_t>(index));
  }
  /// The usable triangles around a point: first and one past the last.
  std::array<const std::int32_t*, 2> trianglesAround(std::int32_t index) const noexcept
  {
    const auto i = static_cast<std::size_t>(index);
    return { this->Incident.data() + this->IncidentStart[i],
      this->Incident.data() + this->IncidentStart[i + 1] };
  }
  const Defects& defects() const noexcept { return this->Found; }
  /// No border and no defect: the surface encloses a volume.
  bool isClosed() const noexcept;
  /// Volume enclosed by the usable triangles, mm³, negative when they wind inward.
  double enclosedVolume() const noexcept;

  /// Unsigned closest point of one triangle.
  TriangleProjection project(const Vector3& tip, std::int32_t triangle) const noexcept;
  /// Adds the side of the tip to a closest point.
  SurfacePoint orient(
    const Vector3& tip, std::int32_t triangle, const TriangleProjection& projection) const noexcept;

private:
  static constexpr std::int32_t Border = -1;
  static constexpr std::int32_t Unusable = -2;

  void findUsable();
  void linkPoints();
  void linkNeighbours();
  void computePointNormals();
  Vector3 faceNormal(std::int32_t triangle) const noexcept;

  std::vector<double> Points;
  std::vector<std::array<std::int32_t, 3>> Triangles;
  std::vector<std::array<std::int32_t, 3>> Neighbours; ///< across edge i, or Border, or Unusable
  std::vector<std::size_t> IncidentStart;
  std::vector<std::int32_t> Incident;
  std::vector<double> PointNormals;
  std::vector<bool> OnBorder;
  Defects Found;
};
} // namespace palpate

#endif
