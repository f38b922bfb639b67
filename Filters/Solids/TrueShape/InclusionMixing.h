// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_InclusionMixing_h
#define palpate_InclusionMixing_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Young's modulus (MPa) of a cell that an inclusion fills in part. `fraction`: fraction of the
 * volume.
 *
 * For a harder inclusion the result is the harmonic mean, for a softer one the geometric mean. On
 * cells of half the depth of a nodule with ten times or a fifth of the modulus, the error of the
 * force is then below 5 %. Arithmetic means give errors up to 18 % (tables shape/nodule_*.csv).
 */
PALPATE_EXPORT double mixedModulus(double around, double inclusion, double fraction);
} // namespace palpate

#endif
