// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TriangleSpans_h
#define palpate_TriangleSpans_h

#include <cstddef>
#include <cstdint>

namespace palpate
{
/// A body's triangles as they lie in memory; those without an area take no part.
struct TriangleSpans
{
  const double* points = nullptr; ///< x, y, z of each, mm
  std::size_t pointCount = 0;
  const std::int32_t* triangles = nullptr; ///< three points each
  std::size_t triangleCount = 0;
};
} // namespace palpate

#endif
