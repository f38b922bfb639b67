// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SmallStrainError_h
#define palpate_SmallStrainError_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * How far the laws of small strain are off, as a fraction of the force, where the body is
 * Neo-Hooke: the size of c - 1, c = F_finite/F_small, with what its estimate leaves over.
 *
 * Half-space: c - 1 = K(ν) s, one number for every tool, s the mean pressure over E*, F/(πa²E*).
 * Layer on a rigid base: k(ν) s + b(ν) (δ/h)(a/h)/(1/2 + a/h). K, k and b were fitted to finite
 * elements (sphere, flat, cone to s = 0.55; sphere on layers of half to four radii to δ/h = 0.5).
 *
 * `depthOverThickness` and `radiusOverThickness` are 0 on a half-space.
 */
PALPATE_EXPORT double smallStrainError(
  double pressure, double poissonsRatio, double depthOverThickness, double radiusOverThickness);
} // namespace palpate

#endif
