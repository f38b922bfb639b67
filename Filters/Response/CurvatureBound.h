// SPDX-License-Identifier: BSD-3-Clause
#ifndef CurvatureBound_h
#define CurvatureBound_h

#include <vector>

class vtkPolyData;

namespace palpate
{
/**
 * Largest normal curvature met along the edges at each point, 1/mm:
 *   max over edges ij of |(n_j - n_i)·(x_j - x_i)| / |x_j - x_i|²,
 * exact on a sphere. Negative where no triangle with an area meets. `normals` are 3 floats per
 * point, unit length; `body` has triangles only.
 *
 * One threaded pass over the triangles. The maximum commutes, so the result has the same bits for
 * any number of threads.
 */
std::vector<float> curvatureBound(vtkPolyData* body, const float* normals);
} // namespace palpate

#endif
