// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactRegime_h
#define palpate_ContactRegime_h

#include "Mechanics/IndentationLaw.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Regime index λ = 1 - δ_hs(F)/δ: the part of the deflection in excess of the half-space
 * indentation of the same tool under the same force, as a fraction of the deflection.
 *
 * λ is 0 if the deformation is local and near 1 if it is global. In the series model it is C F/δ.
 * It is negative if a base close to the surface stiffens the body. λ depends on the load; therefore
 * always state δ with λ. `halfSpace` is the law of the tool on a half-space, `reducedModulus` the
 * E* of the body's surface (MPa), and `force` is F (N) at `deflection` δ (mm). Returns NaN if F or
 * δ is not positive and finite.
 */
PALPATE_EXPORT double regimeIndex(
  const IndentationLaw& halfSpace, double reducedModulus, double force, double deflection);

/// Whether the shape of the tool has an effect.
enum class RegimeVerdict : unsigned char
{
  /// A tool twice as large changes the force by more than 10 %, which a hand can feel.
  ShapeMatters,
  Mixed,
  PointForceSuffices ///< a tool four times as large changes the force by less than 5 %
};

/**
 * Returns the verdict for the tool sensitivity S = dlnF/dln(size) at fixed δ. λ does not determine
 * the verdict: on a thin layer λ is small or negative, although the size has more effect than on a
 * half-space.
 */
PALPATE_EXPORT RegimeVerdict regimeVerdict(double sensitivity);
} // namespace palpate

#endif
