// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_VisibleDent_h
#define palpate_VisibleDent_h

#include "Solids/FiniteElements/BodySurface.h"

#include <vector>

namespace palpate
{
/**
 * Returns, for each point of the surface, the included fraction of the dent under a force at
 * `point`. The fraction is 1 where the surface is connected to `point` and its normal is within 50°
 * of the normal at `point`. It decreases to 0 at 60°, and is 0 elsewhere.
 */
std::vector<double> dentFades(const BodySurface& surface, std::int32_t point);

/**
 * Returns Boussinesq's surface displacement at the point `at` under an inward force of 1 N at
 * `point`, for E = 1 MPa. Its components are u_n = 1/(πE*r) along the direction of the force and
 * u_r = -(1-2ν)(1+ν)/(2πEr). r is the straight distance of the two points, but at least `nearest`
 * (mm).
 */
Eigen::Vector3d dentAt(const BodySurface& surface, std::int32_t point, std::int32_t at,
  double nearest, double poissonRatio);
} // namespace palpate

#endif
