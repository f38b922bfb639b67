// SPDX-License-Identifier: BSD-3-Clause
#ifndef LargeTriangles_h
#define LargeTriangles_h

#include <vector>

class vtkPolyData;

namespace palpate
{
class YieldField;
struct SurfaceYield;

/**
 * Compares the compliance inside large triangles with the value interpolated from the corners. The
 * two may differ much: a cube is compliant at its corners and stiff at its faces. A triangle is
 * large if a side is longer than twice the first contact radius in `radii`. If the values inside
 * are closer to 0 than to the interpolated value, the compliance at the three corners is set to 0.
 * The law there is then that of a half-space. The largest remaining difference is added to the
 * errors of the corners.
 */
void includeLargeTriangles(vtkPolyData* surface, const YieldField& field,
  const std::vector<double>& radii, SurfaceYield& made);
} // namespace palpate

#endif
