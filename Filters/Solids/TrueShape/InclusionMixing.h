// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_InclusionMixing_h
#define palpate_InclusionMixing_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Returns the Young's modulus (MPa) of a cell that an inclusion partly fills. `fraction` is the
 * volume fraction of the inclusion.
 *
 * For a harder inclusion, the result is the harmonic mean; for a softer inclusion, it is the
 * geometric mean. For nodules with ten times or a fifth of the surrounding modulus, and cells of
 * half the nodule's depth, the error of the force is then below 5 %. Arithmetic means give errors
 * of up to 18 % (tables shape/nodule_*.csv).
 */
PALPATE_EXPORT double mixedModulus(double around, double inclusion, double fraction);
} // namespace palpate

#endif
