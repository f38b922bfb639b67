// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_GapOfSurface_h
#define palpate_GapOfSurface_h

#include "Contact/BodyMesh.h"
#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/SurfaceGap.h"

#include <cstdint>

namespace palpate
{
/**
 * How a surface falls off around one of its points, up to a radius (mm): the part connected to the
 * point whose normals are within 60° of its own, smooth between its points (SmoothTriangle) except
 * at creases, where the facets are used. `normals`: three floats a point, unit length.
 *
 * Where a ring is incomplete, at a border or beyond an edge, the surface is not known beyond it.
 * From any number of threads. Cost: 50 µs, and 1 µs per triangle within the radius.
 */
PALPATE_EXPORT SurfaceGap gapOfSurface(
  const BodyMesh& mesh, const float* normals, std::int32_t point, double radius);
} // namespace palpate

#endif
