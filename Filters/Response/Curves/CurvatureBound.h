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
 * Upper bound of the curvature at each point, 1/mm: the largest normal curvature along its edges,
 * max over edges ij of |(n_j - n_i)·(x_j - x_i)| / |x_j - x_i|².
 * On a sphere the bound is exact.
 *
 * It is built in one threaded pass over the triangles. A maximum does not depend on the order, so
 * the bits do not depend on the number of threads or of pieces of the body. At a seam the bound is
 * the maximum over all pieces.
 */
class CurvatureBound
{
public:
  /// `body`: the body, or this rank's piece; it has triangles only. `normals`: unit vectors, 3
  /// floats per point, equal on all pieces at a seam. Collective.
  CurvatureBound(vtkPolyData* body, const BodySeam& seam, const float* normals);

  /// The bound at a point, 1/mm; negative if the point has no triangle with an area.
  float at(vtkIdType point) const noexcept;

private:
  void joinAlong(const BodySeam& seam);

  /// 0 if the point has no edge, otherwise the bits of the bound plus one. The bits of non-negative
  /// floats have the same order as the floats, so an integer maximum can be used.
  std::vector<std::atomic<std::int32_t>> Raised;
};
} // namespace palpate

#endif
