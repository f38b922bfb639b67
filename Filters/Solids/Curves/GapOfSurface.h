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
 * Returns the shape of a surface around the point `point`, up to `radius` (mm). Includes only the
 * part of the surface that is connected to the point and whose normals are within 60° of the
 * point's normal. The surface is interpolated smoothly between its points (SmoothTriangle), except
 * at creases, where the facets are used. `normals` contains unit vectors, three floats per point.
 *
 * At a border or an edge, a ring around the point is incomplete, and the shape is not known beyond
 * this ring. Thread-safe. Cost: 50 µs, plus 1 µs per triangle within the radius.
 */
PALPATE_EXPORT SurfaceGap gapOfSurface(
  const BodyMesh& mesh, const float* normals, std::int32_t point, double radius);
} // namespace palpate

#endif
