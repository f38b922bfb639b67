// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_InclusionMixing_h
#define palpate_InclusionMixing_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Young's modulus (MPa) of a cell that an inclusion fills in part, `fraction` of its volume.
 *
 * Of an inclusion that is harder than what is around it the harmonic mean, of a softer one the
 * geometric: on cells of half the depth of a nodule of ten times and a fifth of the modulus the
 * force on it then errs by less than 5 %; arithmetic means err by up to 18 % (tables
 * shape/nodule_*.csv).
 */
PALPATE_EXPORT double mixedModulus(double around, double inclusion, double fraction);
} // namespace palpate

#endif
