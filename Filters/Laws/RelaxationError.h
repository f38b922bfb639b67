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
 * relative to the largest force of the motion, for a tool with F ∝ δ^m. It is the largest error of
 * ramps, holds, triangles, sines, stop-and-go and random presses down to the curve's last sample,
 * for materials with Σ p from 1 to 4, at 1 kHz (Data/Reference/rate/tick_variants.csv). The table
 * does not include smaller Σ p; the error is assumed to be the same. It is interpolated linearly
 * between the table's m (1, 1.5, 2) and extrapolated above, and interpolated by a power between the
 * table's numbers of elements (4, 8, 16), and above 16 extrapolated with the power from 8 to 16.
 * Presses to a tenth of the depth use few of the elements: with 16 elements their error is up to
 * four times as large, relative to their own largest force.
 *
 * The array Error of a response is the error of its slow curve, to which this error must be added.
 */
PALPATE_EXPORT double relaxationError(int elements, double exponent);

/// The number of elements that a relaxing body needs for a tolerance.
struct RelaxationNeed
{
  double strength =
    0.0;               ///< largest Σ p of a point: relative excess of a fast force over a slow one
  bool isFelt = false; ///< the excess exceeds the tolerance
  int elements = 0;    ///< smallest of 0, 4, 8, 16, 32 within the tolerance; 32 if there is none
  double error = 0.0;  ///< error with `elements` elements
  double simplest = 0.0; ///< error with 0 elements
};

/// `points` is the number of points of terms.strength. `tolerance` (> 0) is relative to the force.
PALPATE_EXPORT RelaxationNeed relaxationNeed(
  const RelaxationTerms& terms, std::size_t points, double tolerance);

/// The need as a sentence without its full stop; "" for a body without relaxation.
PALPATE_EXPORT std::string relaxationReason(
  const RelaxationNeed& need, const PronySeries& series, double tolerance);
} // namespace palpate

#endif
