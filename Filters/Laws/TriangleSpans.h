// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TriangleSpans_h
#define palpate_TriangleSpans_h

#include <cstddef>
#include <cstdint>

namespace palpate
{
/// View of a body's triangles; those without an area are ignored.
struct TriangleSpans
{
  const double* points = nullptr; ///< x, y, z of each, mm
  std::size_t pointCount = 0;
  const std::int32_t* triangles = nullptr; ///< three points each
  std::size_t triangleCount = 0;
};
} // namespace palpate

#endif
