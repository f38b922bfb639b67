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
 * Error of the force of a relaxing body with a number of elements (0: the quasi-linear law),
 * relative to the largest force of the motion, for a tool with F ∝ δ^m.
 *
 * It is the largest error of ramps, holds, triangles, sines, stop-and-go and random presses down to
 * the curve's last sample, for materials with Σ p from 1 to 4, at 1 kHz
 * (Data/Reference/rate/tick_variants.csv). The table does not include smaller Σ p; the error is
 * assumed to be the same.
 *
 * Over m the error is interpolated linearly between the values of the table (1, 1.5, 2), and
 * extrapolated above. Over the number of elements it is interpolated by a power between the values
 * of the table (4, 8, 16). Above 16 it is extrapolated with the power from 8 to 16. Presses to a
 * tenth of the depth use few of the elements. With 16 elements their error is up to four times as
 * large, relative to their own largest force.
 *
 * The array Error of a response is the error of its slow curve, to which this error must be added.
 */
PALPATE_EXPORT double relaxationError(int elements, double exponent);

/// The number of elements that a relaxing body needs for a tolerance.
struct RelaxationNeed
{
  /// Largest Σ p of a point: relative excess of a fast force over a slow force.
  double strength = 0.0;
  bool isFelt = false;   ///< the excess exceeds the tolerance
  int elements = 0;      ///< smallest of 0, 4, 8, 16, 32 within the tolerance; 32 if there is none
  double error = 0.0;    ///< error with `elements` elements
  double simplest = 0.0; ///< error with 0 elements (the quasi-linear law)
};

/// `points` is the number of values of terms.strength. `tolerance` (> 0) is relative to the force.
PALPATE_EXPORT RelaxationNeed relaxationNeed(
  const RelaxationTerms& terms, std::size_t points, double tolerance);

/// Returns the need as a sentence without its full stop; "" for a body without relaxation.
PALPATE_EXPORT std::string relaxationReason(
  const RelaxationNeed& need, const PronySeries& series, double tolerance);
} // namespace palpate

#endif
