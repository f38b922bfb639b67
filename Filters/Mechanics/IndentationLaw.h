// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_IndentationLaw_h
#define palpate_IndentationLaw_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// One point of a force-deflection curve.
struct IndentationPoint
{
  double force = 0.0;         ///< N
  double stiffness = 0.0;     ///< dF/dδ, N/mm
  double contactRadius = 0.0; ///< mm
};

/**
 * The force of one tool that is pressed to a depth δ into one body, for any modulus of the body. F
 * and dF/dδ are proportional to E* = E/(1-ν²).
 *
 * F(δ) is convex and increases from 0. The results are 0 for δ <= 0, and NaN if δ is NaN or beyond
 * the end of the law. Units: mm, N, MPa. Immutable; can be called from any number of threads.
 */
class PALPATE_EXPORT IndentationLaw
{
public:
  virtual ~IndentationLaw() = default;
  virtual IndentationPoint evaluate(double deflection, double reducedModulus) const = 0;
};
} // namespace palpate

#endif
