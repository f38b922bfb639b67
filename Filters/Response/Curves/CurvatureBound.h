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
 * Largest normal curvature along the edges at each point, 1/mm:
 *   max over edges ij of |(n_j - n_i)·(x_j - x_i)| / |x_j - x_i|²,
 * exact on a sphere.
 *
 * Built in one threaded pass over the triangles. A maximum does not depend on the order, so the
 * bits do not depend on the number of threads or of pieces of the body. At a seam it is the maximum
 * over all pieces.
 */
class CurvatureBound
{
public:
  /// `body`, or this rank's piece of it, has triangles only. `normals`: 3 floats per point, unit
  /// length, the same on all pieces at a seam. Collective.
  CurvatureBound(vtkPolyData* body, const BodySeam& seam, const float* normals);

  /// The bound at a point, 1/mm; negative if the point has no triangle with an area.
  float at(vtkIdType point) const noexcept;

private:
  void joinAlong(const BodySeam& seam);

  /// 0 if no edge was found, otherwise the bits of the bound plus one. Non-negative floats have the
  /// order of their bits.
  std::vector<std::atomic<std::int32_t>> Raised;
};
} // namespace palpate

#endif
