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
 * Finds the creases of a surface (see PackedMesh). The surface can be cut at convex creases, so
 * that its faces are no longer connected there. This class decides which edges are cut, and divides
 * the triangles around each point into connected parts. It is used while a mesh is built, and for
 * the curvature of faces.
 */
class PALPATE_EXPORT CreaseCut
{
public:
  /// The triangles must be wound consistently. `coordinates` has three floats per point. Only the
  /// first `usable` triangles have an area.
  CreaseCut(const std::vector<TriangleCorners>& triangles, std::size_t usable,
    const std::vector<float>& coordinates, const TriangleLinks& links, double leastTurn);

  /// Returns both sides of each convex crease, at which the surface is cut, ordered by triangle.
  const std::vector<PackedMesh::CreaseSide>& sides() const noexcept { return this->Sides; }
  /// Returns the index of the part that contains a corner of a triangle, among the parts around the
  /// corner's point; 0 if the surface is not cut there.
  int part(std::size_t triangle, std::size_t corner) const noexcept
  {
    return this->Parts[3 * triangle + corner];
  }
  /// Marks the triangles with a corner on a crease between flat faces, if the surface is not cut
  /// there: a concave crease and, unless `isCut`, a convex one. The normals of the points there
  /// differ from those of the faces. At such a crease the turn is at least 43° and at least five
  /// times the smallest turn at the other sides of each of its two triangles, and at both ends of
  /// the edge another such crease ends. Returns 1 for each marked triangle, else 0; empty if no
  /// triangle is marked.
  std::vector<std::uint8_t> folded(bool isCut) const;

private:
  void findSides(std::size_t usable, const std::vector<float>& coordinates, double leastTurn);
  void partAround(std::int32_t point);
  void dropUncut();
  std::size_t cornerOf(std::size_t triangle, std::int32_t point) const;

  const std::vector<TriangleCorners>& Triangles;
  const TriangleLinks& Links;
  std::vector<PackedMesh::CreaseSide> Sides;
  std::vector<PackedMesh::CreaseSide> Folds; ///< both sides of each crease between flat faces
  std::vector<std::uint8_t> IsCut;           ///< 3 values per triangle
  std::vector<int> Parts;                    ///< 3 values per triangle
};
} // namespace palpate

#endif
