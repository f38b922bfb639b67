// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ReducedModulus_h
#define palpate_ReducedModulus_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// Whether E is a usable Young's modulus: finite and positive (MPa).
PALPATE_EXPORT bool isYoungsModulus(double youngsModulus);

/// Whether nu is a Poisson's ratio for which the half-space laws hold: 0 <= nu <= 0.5.
PALPATE_EXPORT bool isPoissonsRatio(double poissonsRatio);

/// E* = E / (1 - nu^2), in the unit of E (MPa here); the tool is rigid.
/// NaN when E or nu is outside its range.
PALPATE_EXPORT double reducedModulus(double youngsModulus, double poissonsRatio);
} // namespace palpate

#endif
