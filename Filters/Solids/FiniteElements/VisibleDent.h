// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_VisibleDent_h
#define palpate_VisibleDent_h

#include "Solids/FiniteElements/BodySurface.h"

#include <vector>

namespace palpate
{
/**
 * Fraction of the dent under a force at `point` that is included at each point of the surface. It
 * is 1 where the surface is connected to `point` and its normal is within 50° of the normal at
 * `point`, fades to 0 at 60°, and is 0 elsewhere.
 */
std::vector<double> dentFades(const BodySurface& surface, std::int32_t point);

/**
 * Displacement of Boussinesq's surface at the point `at` of the body under 1 N pressed into it at
 * `point`, for E = 1 MPa: u_n = 1/(πE*r) along the normal of the force and u_r =
 * -(1-2ν)(1+ν)/(2πEr), with the straight distance r, at least `nearest` (mm).
 */
Eigen::Vector3d dentAt(const BodySurface& surface, std::int32_t point, std::int32_t at,
  double nearest, double poissonRatio);
} // namespace palpate

#endif
