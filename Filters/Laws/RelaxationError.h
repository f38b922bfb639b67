// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RelaxationError_h
#define palpate_RelaxationError_h

#include "Contact/Relaxation/RelaxationTerms.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <string>

namespace palpate
{
/**
 * Error of the force of a relaxing body, relative to the largest force of the motion, with a number
 * of elements (0: the quasi-linear law) and a tool of F ∝ δ^m: the worst of ramps, holds,
 * triangles, sines, stop-and-go and presses at random down to the curve's last sample, of materials
 * with Σ p from 1 to 4, at 1 kHz (Data/Reference/rate/tick_variants.csv). Smaller Σ p, which the
 * table does not include, get the same. Interpolated linearly between its m (1, 1.5, 2),
 * extrapolated above; by a power between its numbers of elements (4, 8, 16), extrapolated above as
 * from 8 to 16. Presses a tenth as deep reach few of the elements: with 16, up to four times the
 * error, relative to their own largest force.
 *
 * The array Error of a response is that of its slow curve; this error adds to it.
 */
PALPATE_EXPORT double relaxationError(int elements, double exponent);

/// The elements that a tolerance needs on a body that relaxes.
struct RelaxationNeed
{
  double strength =
    0.0;               ///< the largest Σ p of a point: by how much a fast force exceeds a slow one
  bool isFelt = false; ///< by more than the tolerance
  int elements = 0;    ///< the fewest of 0, 4, 8, 16, 32 that keep the tolerance; 32 if none does
  double error = 0.0;  ///< with them
  double simplest = 0.0; ///< with 0
};

/// `points` are those of terms.strength; `tolerance` > 0 is of the force.
PALPATE_EXPORT RelaxationNeed relaxationNeed(
  const RelaxationTerms& terms, std::size_t points, double tolerance);

/// The need in a sentence without its full stop; "" for a body without relaxation.
PALPATE_EXPORT std::string relaxationReason(
  const RelaxationNeed& need, const PronySeries& series, double tolerance);
} // namespace palpate

#endif
