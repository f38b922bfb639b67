// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HilbertCurve_h
#define palpate_HilbertCurve_h

#include <array>
#include <cstdint>
#include <vector>

namespace palpate
{
/// Returns the position of a cell of a 2^16 x 2^16 x 2^16 grid along Hilbert's space-filling curve.
/// Cells that are adjacent along the curve are neighbours in space (Skilling 2004, Programming the
/// Hilbert curve, AIP Conf. Proc. 707, 381).
std::uint64_t hilbertKey(std::array<std::uint32_t, 3> cell) noexcept;

/// Sorts triangles by the positions of their centroids along the curve. Triangles in the same cell
/// are sorted by index. `corners` has three point indices for each triangle, `coordinates` three
/// finite floats for each point. Threaded; the result does not depend on the number of threads.
void sortAlongCurve(
  std::vector<std::int32_t>& triangles, const std::int32_t* corners, const float* coordinates);
} // namespace palpate

#endif
