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
class BodySeam;

/**
 * Largest normal curvature met along the edges at each point, 1/mm:
 *   max over edges ij of |(n_j - n_i)·(x_j - x_i)| / |x_j - x_i|²,
 * exact on a sphere.
 *
 * Built in one threaded pass over the triangles. The maximum commutes, so the result has the same
 * bits for any number of threads, and of pieces of the body: at a seam it is the maximum over all
 * pieces.
 */
class CurvatureBound
{
public:
  /// `body`, or the own piece of it, has triangles only; `normals` are 3 floats per point, unit
  /// length, the same on all pieces at a seam. Collective.
  CurvatureBound(vtkPolyData* body, const BodySeam& seam, const float* normals);

  /// Negative where no triangle with an area meets.
  float at(vtkIdType point) const noexcept;

private:
  void joinAlong(const BodySeam& seam);

  /// 0 where no edge was seen, otherwise the bits of the bound plus one: non-negative floats are
  /// ordered as their bits.
  std::vector<std::atomic<std::int32_t>> Raised;
};
} // namespace palpate

#endif
