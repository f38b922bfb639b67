// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltedFlat_h
#define palpate_TiltedFlat_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// A function of one variable and its first two derivatives.
struct TiltedFlatTerm
{
  double value;
  double slope;
  double bend;
};

/**
 * The law of a flat end of radius a on a half-space, tilted by θ. Its deepest point, on the rim, is
 * at the depth D. By similarity one law, a function of q = D/(a sin θ), is valid for all radii and
 * tilts:
 *   F = 2 a² E* sin θ f(q),   W/W_0 = ρ,  f = d(q² ρ/2)/dq.
 * For q >= 3 the whole end touches, and f = q - 1 and ρ = 1 - 2/q + 5/(3q²) are exact. For smaller
 * q, ρ is a polynomial of √(q/3), fitted to boundary elements with f, f' and f'' continuous at q =
 * 3 (Data/Reference/tilt/flat_tilt_universal.csv). Error: 1e-3 for q >= 0.1, 3e-3 at 0.01.
 */
/// Returns f and its derivatives for q > 0.
PALPATE_EXPORT TiltedFlatTerm tiltedFlatForce(double q) noexcept;

/// Returns ρ as a function of s = 3/q >= 0, which is three times the drop of the rim divided by the
/// depth.
PALPATE_EXPORT TiltedFlatTerm tiltedFlatWork(double s) noexcept;
} // namespace palpate

#endif
