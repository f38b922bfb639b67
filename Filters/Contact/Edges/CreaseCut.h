// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CreaseCut_h
#define palpate_CreaseCut_h

#include "Contact/PackedMesh.h"
#include "Contact/TriangleLinks.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/**
 * Finds the creases of a surface (see PackedMesh). At convex creases the surface can be cut, so
 * that its faces are no longer connected there: this class decides which edges are cut, and finds
 * the parts into which the triangles around a point are divided. Used while a mesh is built, and
 * for the curvature of its faces.
 */
class PALPATE_EXPORT CreaseCut
{
public:
  /// The triangles of `triangles` are wound alike; `coordinates` has three floats per point. Only
  /// the first `usable` triangles have an area.
  CreaseCut(const std::vector<TriangleCorners>& triangles, std::size_t usable,
    const std::vector<float>& coordinates, const TriangleLinks& links, double leastTurn);

  /// Both sides of each convex crease, where the surface is cut, ordered by triangle.
  const std::vector<PackedMesh::CreaseSide>& sides() const noexcept { return this->Sides; }
  /// The part to which a corner of a triangle belongs, among the parts around its point; 0 if the
  /// surface is not cut there.
  int part(std::size_t triangle, std::size_t corner) const noexcept
  {
    return this->Parts[3 * triangle + corner];
  }
  /// The triangles that have a corner on a crease where the surface is not cut: a concave crease
  /// and, unless `isCut`, a convex one. Normals of points are not those of the faces there. Values
  /// are 1 for such a triangle; empty if there is none.
  std::vector<std::uint8_t> folded(bool isCut) const;

private:
  void findSides(std::size_t usable, const std::vector<float>& coordinates, double leastTurn);
  void partAround(std::int32_t point);
  void dropUncut();
  std::size_t cornerOf(std::size_t triangle, std::int32_t point) const;

  const std::vector<TriangleCorners>& Triangles;
  const TriangleLinks& Links;
  std::vector<PackedMesh::CreaseSide> Sides;
  std::vector<PackedMesh::CreaseSide> Concave; ///< both sides of each concave crease
  std::vector<std::uint8_t> IsCut;             ///< 3 per triangle
  std::vector<int> Parts;                      ///< 3 per triangle
};
} // namespace palpate

#endif
