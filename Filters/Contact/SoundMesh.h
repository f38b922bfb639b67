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
/// Counts of the defects in the triangles of a body. A triangle that is left out has a negative
/// first corner.
struct MeshDefects
{
  std::size_t notFinite = 0;         ///< triangles left out: a coordinate not finite or too large
  std::size_t badIndex = 0;          ///< triangles left out: a corner is not a point
  std::size_t degenerate = 0;        ///< triangles left out: no area
  std::size_t repeatedTriangles = 0; ///< left out: they occur twice, or enclose nothing
  std::size_t hiddenTriangles = 0;   ///< left out: sheets and debris inside a closed body
  std::size_t turnedTriangles = 0;   ///< reversed
  std::size_t joinedPoints = 0;      ///< points with the same coordinates as another one
  /// Edges of more than two triangles, or of two that cannot be wound alike.
  std::size_t nonManifoldEdges = 0;
  std::size_t borderEdges = 0;
};

/**
 * The triangles of a body, repaired: laws, contact, display and mesher all use these triangles.
 *
 * - Triangles are left out if a corner is not a point, if a corner occurs twice, or if coordinates
 *   are not finite or beyond LargestCoordinate.
 * - Open borders are joined at points with the same coordinates (as float32 relative to the centre
 *   of the body's box), and the ends of edges without length are joined. Therefore a surface that
 *   is split for its texture or normals, or that lists each triangle's corners separately, becomes
 *   one surface. Two closed bodies that touch remain two.
 * - Copies of a triangle and flaps are left out (MeshRepeats).
 * - Neighbours are wound alike (makeWindingConsistent), and solids are wound outward (orientParts).
 *
 * Cost: O(n) for a sound body, with 60 bytes of memory per triangle.
 */
class PALPATE_EXPORT SoundMesh
{
public:
  static constexpr double LargestCoordinate = 1e14;

  /// Points are x, y, z (mm); triangles have three point indices. If the body is divided among
  /// several processes (`isPiece`), a piece does not show which side is outside, so that its solids
  /// are not reversed.
  SoundMesh(const double* points, std::size_t pointCount, const std::int32_t* triangles,
    std::size_t triangleCount, bool isPiece = false);

  /// The reason why the surface is not a body, and the part concerned; "" if it is a body.
  const std::string& fault() const noexcept { return this->Fault; }
  const MeshDefects& defects() const noexcept { return this->Found; }

  /// Triangles in the order of the input, with the input's points, wound outward. The first corner
  /// of a triangle that is left out is negative.
  const std::vector<TriangleCorners>& triangles() const noexcept { return this->Triangles; }
  /// Whether a triangle connects its neighbours but has no area after rounding.
  bool isWithoutArea(std::size_t triangle) const noexcept
  {
    return this->WithoutArea[triangle] != 0;
  }

  /// The first of the points with the same coordinates; it represents the others.
  std::int32_t firstAt(std::int32_t point) const noexcept
  {
    return this->First.empty() ? point : this->First[static_cast<std::size_t>(point)];
  }
  bool hasJoinedPoints() const noexcept { return !this->First.empty(); }

  /// Centre of the box of the triangles, mm; and the points relative to it, 3 floats each.
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
