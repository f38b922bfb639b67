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
 * Upper bound of the curvature at each point, 1/mm. It is the largest normal curvature along the
 * edges of the point, max over edges ij of |(n_j - n_i)·(x_j - x_i)| / |x_j - x_i|². On a sphere
 * the bound is exact.
 *
 * The bound is computed in one threaded pass over the triangles. A maximum does not depend on the
 * order of its values. Therefore the result is bitwise the same for any number of threads and any
 * number of pieces of the body. At a seam the bound is the maximum over all pieces.
 */
class CurvatureBound
{
public:
  /// `body` is the whole body or this rank's piece; it has triangles only. `normals` contains unit
  /// vectors, 3 floats per point. At a seam they are equal on all pieces. Collective.
  CurvatureBound(vtkPolyData* body, const BodySeam& seam, const float* normals);

  /// Returns the bound at a point, 1/mm. The bound is negative if no triangle at the point has an
  /// area.
  float at(vtkIdType point) const noexcept;

private:
  void joinAlong(const BodySeam& seam);

  /// For each point: 0 if the point has no edge, otherwise the bits of the bound plus one. The bits
  /// of non-negative floats have the same order as the floats; therefore an integer maximum can be
  /// used.
  std::vector<std::atomic<std::int32_t>> Raised;
};
} // namespace palpate

#endif
