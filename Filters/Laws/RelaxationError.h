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
 * Returns the error of the force of a relaxing body that is computed with `elements` elements (0
 * for the quasi-linear law), relative to the largest force of the motion, for a tool with F ∝ δ^m.
 * `exponent` is m.
 *
 * It is the largest error over ramps, holds, triangular, sinusoidal, stop-and-go and random presses
 * down to the curve's last sample, for materials with Σ p from 1 to 4, at 1 kHz
 * (Data/Reference/rate/tick_variants.csv). The table does not include smaller Σ p; for these the
 * same error is assumed.
 *
 * Over m the error is interpolated linearly between the tabulated values (1, 1.5, 2) and
 * extrapolated above. Over the number of elements it is interpolated by a power between the
 * tabulated values (4, 8, 16). Above 16 it is extrapolated with the power that holds from 8 to 16.
 * Presses to a tenth of the depth use only few of the elements. With 16 elements their error is up
 * to four times as large, relative to their own largest force.
 *
 * The array Error of a response is the error of its slow curve. The error returned here must be
 * added to it.
 */
PALPATE_EXPORT double relaxationError(int elements, double exponent);

/// The number of elements that is needed to keep the error for a relaxing body within a tolerance.
struct RelaxationNeed
{
  /// Largest Σ p of all points: the excess of a fast force over the slow force, relative to the
  /// slow force.
  double strength = 0.0;
  bool isFelt = false; ///< whether the excess exceeds the tolerance
  /// Smallest of 0, 4, 8, 16, 32 with an error within the tolerance; 32 if there is none.
  int elements = 0;
  double error = 0.0;    ///< error with `elements` elements
  double simplest = 0.0; ///< error with 0 elements (the quasi-linear law)
};

/// `points` is the number of points for which terms.strength has values. `tolerance` (> 0) is
/// relative to the force.
PALPATE_EXPORT RelaxationNeed relaxationNeed(
  const RelaxationTerms& terms, std::size_t points, double tolerance);

/// Returns the result as a sentence without its full stop; "" for a body without relaxation.
PALPATE_EXPORT std::string relaxationReason(
  const RelaxationNeed& need, const PronySeries& series, double tolerance);
} // namespace palpate

#endif
