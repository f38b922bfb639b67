// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_VisibleDent_h
#define palpate_VisibleDent_h

#include "Solids/FiniteElements/BodySurface.h"

#include <vector>

namespace palpate
{
/**
 * The fraction of the dent under a force at a point that each point of the surface has, 0 to 1:
 * that of the surface connected to that point and facing the same way, 1 within 50° of the normal
 * there and fading to 0 at 60°.
 */
std::vector<double> dentFades(const BodySurface& surface, std::int32_t point);

/**
 * Boussinesq's surface at a point of the body under 1 N pressed into it at another, for E = 1 MPa:
 * u_n = 1/(πE*r) along the normal of the force and u_r = -(1-2ν)(1+ν)/(2πEr), r the straight
 * distance, not less than `nearest` (mm).
 */
Eigen::Vector3d dentAt(const BodySurface& surface, std::int32_t point, std::int32_t at,
  double nearest, double poissonRatio);
} // namespace palpate

#endif
