// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SoundMesh_h
#define palpate_SoundMesh_h

#include "Contact/TriangleLinks.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{
/// Number of defects of each kind in the triangles of a body. A triangle that is left out has a
/// negative first corner.
struct MeshDefects
{
  std::size_t notFinite = 0; ///< triangles left out because a coordinate is not finite or too large
  std::size_t badIndex = 0;  ///< triangles left out because a corner is not a valid point index
  std::size_t degenerate = 0; ///< triangles left out because they have no area
  /// Triangles left out because they occur twice or enclose nothing.
  std::size_t repeatedTriangles = 0;
  std::size_t hiddenTriangles = 0; ///< triangles left out as sheets or debris inside a closed body
  std::size_t turnedTriangles = 0; ///< triangles whose winding was reversed
  std::size_t joinedPoints = 0;    ///< points with the same coordinates as another point
  /// Edges with more than two triangles, or with two that cannot be wound consistently.
  std::size_t nonManifoldEdges = 0;
  std::size_t borderEdges = 0;
};

/**
 * The triangles of a body, repaired: laws, contact, display and mesher all use these triangles.
 *
 * - Triangles are left out if a corner is not a valid point index, if a corner occurs twice, or if
 *   coordinates are not finite or exceed LargestCoordinate.
 * - Open borders are joined at points with the same coordinates (as float32 relative to the centre
 *   of the body's box), and the ends of zero-length edges are joined. Therefore a surface becomes
 *   one surface even if it is split for its texture or normals, or if its file stores the corners
 *   of each triangle separately. Two closed bodies that touch remain two bodies.
 * - Copies of a triangle and flaps are left out (MeshRepeats).
 * - Neighbours are wound consistently (makeWindingConsistent), and solids are wound outward
 *   (orientParts).
 *
 * Cost: O(n) for a body without defects, with 60 bytes of memory per triangle.
 */
class PALPATE_EXPORT SoundMesh
{
public:
  static constexpr double LargestCoordinate = 1e14;

  /// `points` has x, y, z (mm) of each point, `triangles` three point indices each. `isPiece` means
  /// that the body is divided among several processes. The outer side cannot be determined from one
  /// piece, so that the solids of a piece are not reversed.
  SoundMesh(const double* points, std::size_t pointCount, const std::int32_t* triangles,
    std::size_t triangleCount, bool isPiece = false);

  /// Returns the reason why the surface is not a body, with the part concerned; "" if it is a body.
  const std::string& fault() const noexcept { return this->Fault; }
  const MeshDefects& defects() const noexcept { return this->Found; }

  /// Triangles in the order of the input, with the input's point indices, wound outward. The first
  /// corner of a triangle that is left out is negative.
  const std::vector<TriangleCorners>& triangles() const noexcept { return this->Triangles; }
  /// Returns whether a triangle connects its neighbours but has no area after rounding.
  bool isWithoutArea(std::size_t triangle) const noexcept
  {
    return this->WithoutArea[triangle] != 0;
  }

  /// Returns the first of the points with the same coordinates as `point`; it represents all of
  /// them.
  std::int32_t firstAt(std::int32_t point) const noexcept
  {
    return this->First.empty() ? point : this->First[static_cast<std::size_t>(point)];
  }
  bool hasJoinedPoints() const noexcept { return !this->First.empty(); }

  /// Centre of the box of the triangles, mm, and the coordinates of the points relative to this
  /// centre, 3 floats each.
  const Vector3& centre() const noexcept { return this->Centre; }
  const std::vector<float>& coordinates() const noexcept { return this->Coordinates; }

private:
  void findUsable(const double* points);
  void roundPoints(const double* points);
  void findAreas(const double* points);
  void repair(bool isPiece);
  void joinPoints(const TriangleLinks& links, std::vector<TriangleCorners>& joined);
  void takeOver(const std::vector<TriangleCorners>& repaired);

  std::size_t PointCount;
  std::vector<TriangleCorners> Triangles;
  std::vector<std::uint8_t> WithoutArea;
  std::vector<std::int32_t> First;
  std::vector<float> Coordinates;
  Vector3 Centre = Vector3::Zero();
  MeshDefects Found;
  std::string Fault;
};
} // namespace palpate

#endif
