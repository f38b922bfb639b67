// SPDX-License-Identifier: BSD-3-Clause
#ifndef CurvatureBound_h
#define CurvatureBound_h

#include "vtkType.h"

#include <atomic>
#include <cstdint>
#include <vector>

class vtkPolyData;

namespace palpate
{
/**
 * Largest normal curvature met along the edges at each point, 1/mm:
 *   max over edges ij of |(n_j - n_i)·(x_j - x_i)| / |x_j - x_i|²,
 * exact on a sphere.
 *
 * Built in one threaded pass over the triangles. The maximum commutes, so the result has the same
 * bits for any number of threads.
 */
class CurvatureBound
{
public:
  /// `body` has triangles only; `normals` are 3 floats per point, unit length.
  CurvatureBound(vtkPolyData* body, const float* normals);

  /// Negative where no triangle with an area meets.
  float at(vtkIdType point) const noexcept;

private:
  /// 0 where nothing was met, otherwise the bits of the bound, plus one: non-negative floats order
  /// as their bits.
  std::vector<std::atomic<std::int32_t>> Raised;
};
} // namespace palpate

#endif
