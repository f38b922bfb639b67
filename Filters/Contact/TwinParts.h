// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TwinParts_h
#define palpate_TwinParts_h

#include "Contact/TriangleLinks.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// A range of connected triangles in a list of triangles sorted by part.
struct MeshPart
{
  std::size_t first;
  std::size_t count;
  bool isSolid;
};

/// Leaves out parts that are copies of another part, or of a region of another part, with separate
/// points. The first corner of their triangles becomes -1. Returns the triangles of the walls that
/// two solids share, with the two triangles of each pair one after the other.
///
/// `coordinates` has 3 floats per point. `order` lists the triangles part by part. Takes O(n log n)
/// and 16 bytes per triangle.
std::vector<std::int32_t> dropCopiedParts(const float* coordinates,
  std::vector<TriangleCorners>& triangles, const std::vector<std::int32_t>& order,
  const std::vector<MeshPart>& parts);
} // namespace palpate

#endif
