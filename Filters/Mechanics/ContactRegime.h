// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactRegime_h
#define palpate_ContactRegime_h

#include "Mechanics/IndentationLaw.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Returns the regime index λ = 1 - δ_hs(F)/δ. δ_hs(F) is the indentation of the same tool in a
 * half-space under the same force, so that λ is the remaining fraction of the deflection.
 *
 * λ is 0 if the deformation is local and near 1 if it is global. In the series model it is C F/δ.
 * It is negative if a base close to the surface stiffens the body. λ depends on the load; therefore
 * always state δ together with λ. `halfSpace` is the law of the tool on a half-space,
 * `reducedModulus` the E* of the body's surface (MPa), and `force` is F (N) at `deflection` δ (mm).
 * Returns NaN if F or δ is not positive and finite.
 */
PALPATE_EXPORT double regimeIndex(
  const IndentationLaw& halfSpace, double reducedModulus, double force, double deflection);

/// Whether the shape of the tool has an effect on the force.
enum class RegimeVerdict : unsigned char
{
  /// A tool twice as large changes the force by more than 10 %, which a hand can feel.
  ShapeMatters,
  Mixed,
  PointForceSuffices ///< a tool four times as large changes the force by less than 5 %
};

/**
 * Returns the verdict for the sensitivity S = dlnF/dln(size) of the force to the tool's size at
 * fixed δ. λ does not determine the verdict: on a thin layer λ is small or negative, although the
 * size has more effect than on a half-space.
 */
PALPATE_EXPORT RegimeVerdict regimeVerdict(double sensitivity);
} // namespace palpate

#endif
