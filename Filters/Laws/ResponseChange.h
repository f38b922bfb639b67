// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseChange_h
#define palpate_ResponseChange_h

#include "Laws/ResponseFiller.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// The relative difference between two responses of one tool at one point; NaN if it is unknown.
struct ResponseChange
{
  double force = 0.0;     ///< (F - F₀)/F₀
  double stiffness = 0.0; ///< (K - K₀)/K₀, at the same depth
  double depth = 0.0;     ///< mm
};

/**
 * Finds the depth at which the relative difference in force between `changed` and `usual` at point
 * `i` has the largest magnitude. Both must be stored with exponent 1. The compared depths are
 * evenly spaced in √δ, eight per sample, from 1/samples² of the largest depth to the largest depth.
 * The largest depth is the smallest of `deepest` (mm), both ranges and, with `withinValidity`, both
 * validities. If the changes at several depths are equal within 1e-4, the smallest of these depths
 * is returned. All values are NaN if one of the two has no response, or if there is no depth to
 * compare.
 */
PALPATE_EXPORT ResponseChange largestChange(const ResponseSpans& changed,
  const ResponseSpans& usual, std::size_t i, double deepest, bool withinValidity);
} // namespace palpate

#endif
