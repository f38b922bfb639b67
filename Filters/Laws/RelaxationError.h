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
 * How far off the force of a body that relaxes may be, relative to the largest of the motion, with
 * so many elements (0: the quasi-linear law) and a tool of F ∝ δ^m. The worst of ramps, holds,
 * triangles, sines, stop-and-go and presses at random down to the curve's last sample, of materials
 * with Σ p from 1 to 4, at 1 kHz (Data/Reference/rate/tick_variants.csv). Not less for smaller Σ p,
 * of which the table does not speak. Between its m (1, 1.5, 2) linear, above on as it goes; between
 * its numbers of elements (4, 8, 16) by a power, above as from 8 to 16. Presses a tenth as deep
 * meet few of the elements: up to four times as much of their own largest force with 16.
 *
 * The array Error of a response is that of its slow curve; this comes on top.
 */
PALPATE_EXPORT double relaxationError(int elements, double exponent);

/// What a tolerance needs of a body that relaxes.
struct RelaxationNeed
{
  double strength =
    0.0;               ///< the largest Σ p of a point: by how much a fast force exceeds a slow one
  bool isFelt = false; ///< by more than the tolerance
  int elements = 0;    ///< the fewest of 0, 4, 8, 16, 32 that keep it; 32 where none does
  double error = 0.0;  ///< with them
  double simplest = 0.0; ///< with 0
};

/// `points` are those of terms.strength; `tolerance` > 0 is of the force.
PALPATE_EXPORT RelaxationNeed relaxationNeed(
  const RelaxationTerms& terms, std::size_t points, double tolerance);

/// The need in a sentence without its stop; "" of a body that has no relaxation.
PALPATE_EXPORT std::string relaxationReason(
  const RelaxationNeed& need, const PronySeries& series, double tolerance);
} // namespace palpate

#endif
