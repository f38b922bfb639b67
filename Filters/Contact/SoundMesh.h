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
/// Counts of the defects in the triangles of a body.
struct MeshDefects
{
  std::size_t notFinite = 0;         ///< triangles left out: a coordinate not finite or too large
  std::size_t badIndex = 0;          ///< triangles left out: a corner is not a point
  std::size_t degenerate = 0;        ///< triangles left out: no area
  std::size_t repeatedTriangles = 0; ///< left out: they occur twice, or enclose nothing
  std::size_t hiddenTriangles = 0;   ///< left out: sheets and debris inside a closed body
  std::size_t turnedTriangles = 0;   ///< reversed
  std::size_t joinedPoints = 0;      ///< points at the place of another one
  std::size_t nonManifoldEdges = 0;  ///< of more than two triangles, or not orientable
  std::size_t borderEdges = 0;
};

/**
 * The triangles of a body, repaired: laws, contact, display and mesher use the same ones.
 *
 * - Triangles are left out if a corner is not a point, if a corner occurs twice, or if coordinates
 *   are not finite or beyond LargestCoordinate.
 * - Open borders are joined where points have the same coordinates (as float32 about the centre of
 *   the body's box), and so are the ends of edges without length. So a surface that is split for
 *   its texture or normals, or that lists each triangle's corners, becomes one surface. Two closed
 *   bodies that touch remain two.
 * - Copies of a triangle and flaps are left out (MeshRepeats).
 * - Neighbours are wound alike (makeWindingConsistent), and solids are wound outward (orientParts).
 *
 * Cost: O(n) for a sound body, in memory 60 bytes per triangle.
 */
class PALPATE_EXPORT SoundMesh
{
public:
  static constexpr double LargestCoordinate = 1e14;

  /// Points are x, y, z (mm); triangles have three point indices. A piece of a body on several
  /// processes does not show which side is outside, so its solids are not turned.
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

  /// The first of the points at the same place; it represents the others.
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
