// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseChange_h
#define palpate_ResponseChange_h

#include "Laws/ResponseFiller.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// How two responses of one tool at one place differ, relative to the second; NaN: not known.
struct ResponseChange
{
  double force = 0.0;     ///< (F - F₀)/F₀
  double stiffness = 0.0; ///< (K - K₀)/K₀, at the same depth
  double depth = 0.0;     ///< mm
};

/**
 * Where `changed` differs most in force from `usual` at point `i` of both, whose exponent of
 * storage is 1: by magnitude, at one of eight depths between each two samples, from the first
 * sample to `deepest` (mm) or where the shorter of the two ranges ends, of the validities too if
 * `withinValidity`. Of depths whose changes are equal within 1e-4 of themselves, the least.
 * All NaN where one of the two has no response, or no depth is left.
 */
PALPATE_EXPORT ResponseChange largestChange(const ResponseSpans& changed,
  const ResponseSpans& usual, std::size_t i, double deepest, bool withinValidity);
} // namespace palpate

#endif
