// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SmallStrainError_h
#define palpate_SmallStrainError_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Returns the relative error of the force of small-strain laws on a Neo-Hooke body: |c - 1| with c
 * = F_finite/F_small, plus the residual of the estimate of c.
 *
 * On a half-space c - 1 = K(ν) s with the same K for every tool; s = F/(πa²E*) is the mean pressure
 * divided by E*. On a layer with a rigid base it is k(ν) s + b(ν) (δ/h)(a/h)/(1/2 + a/h). K, k and
 * b were fitted to finite elements (sphere, flat end and cone to s = 0.55; sphere on layers of half
 * to four radii to δ/h = 0.5).
 *
 * `pressure` is s. `depthOverThickness` is δ/h and `radiusOverThickness` a/h; both are 0 on a
 * half-space.
 */
PALPATE_EXPORT double smallStrainError(
  double pressure, double poissonRatio, double depthOverThickness, double radiusOverThickness);
} // namespace palpate

#endif
