// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactRegime_h
#define palpate_ContactRegime_h

#include "Mechanics/IndentationLaw.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Regime index λ = 1 - δ_hs(F)/δ: the fraction of the deflection in excess of the half-space
 * indentation of the same tool under the same force.
 *
 * 0 where deformation is local, near 1 where it is global (C F/δ in the series model), and negative
 * where a near base stiffens the body. It depends on the load: always state δ. `halfSpace` is the
 * tool's own law, E* (MPa) that of the body's surface, F (N) the force at δ (mm). NaN unless F and
 * δ are positive and finite.
 */
PALPATE_EXPORT double regimeIndex(
  const IndentationLaw& halfSpace, double reducedModulus, double force, double deflection);

/// Whether the shape of the tool matters.
enum class RegimeVerdict : unsigned char
{
  ShapeMatters, ///< a tool twice as large changes the force by more than 10 %, which can be felt
  Mixed,
  PointForceSuffices ///< a tool four times as large changes the force by less than 5 %
};

/**
 * The verdict from the tool sensitivity S = dlnF/dln(size) at fixed δ. It cannot rest on λ: on
 * a thin layer λ is small or negative, and size matters more than on a half-space.
 */
PALPATE_EXPORT RegimeVerdict regimeVerdict(double sensitivity);
} // namespace palpate

#endif
