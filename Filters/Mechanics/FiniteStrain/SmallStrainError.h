// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SmallStrainError_h
#define palpate_SmallStrainError_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * The relative error of the force of the small-strain laws on a Neo-Hooke body: |c - 1| with c =
 * F_finite/F_small, plus the residual of the estimate of c.
 *
 * Half-space: c - 1 = K(ν) s with the same K for every tool; s is the mean pressure over E*,
 * F/(πa²E*). Layer on a rigid base: k(ν) s + b(ν) (δ/h)(a/h)/(1/2 + a/h). K, k and b were fitted to
 * finite elements (sphere, flat, cone to s = 0.55; sphere on layers of half to four radii to δ/h =
 * 0.5).
 *
 * `depthOverThickness` and `radiusOverThickness` are 0 on a half-space.
 */
PALPATE_EXPORT double smallStrainError(
  double pressure, double poissonRatio, double depthOverThickness, double radiusOverThickness);
} // namespace palpate

#endif
