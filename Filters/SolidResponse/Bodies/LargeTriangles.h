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
 * Compares the compliance inside large triangles with the value blended from the corners, which may
 * be far from it: the corners of a cube yield much, its faces little. A triangle is large if a side
 * is longer than twice the first of the radii. If 0 is closer to the values inside than the blend,
 * the compliance of the three corners is set to 0, so that the law is that of a half-space. The
 * largest remaining difference is added to the errors of the corners.
 */
void includeLargeTriangles(vtkPolyData* surface, const YieldField& field,
  const std::vector<double>& radii, SurfaceYield& made);
} // namespace palpate

#endif
