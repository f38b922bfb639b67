// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DepthLimit_h
#define palpate_DepthLimit_h

#include "Mechanics/PalpateExport.h"

#include <functional>
#include <limits>
#include <vector>

namespace palpate
{
/// The end of a half-space law: pressed deeper than `depth`, the tool would touch the body again at
/// `radius`, outside the one circle of contact. mm; +inf and NaN if that never happens.
struct DepthLimit
{
  double depth = std::numeric_limits<double>::infinity();
  double radius = std::numeric_limits<double>::quiet_NaN();
};

/**
 * Depth up to which the profile f(r), r <= outer, touches a half-space in one full circle.
 *
 * With the reduced profile g and g(a) = δ the gap outside the contact is
 *   f(r) - δ + (2/π) [δ asin(a/r) + ∫_0^a g dx/√(r²-x²) ... ] = (2/π) ∫_a^r (g-δ) dx/√(r²-x²),
 * which is never negative if g increases everywhere. Where g decreases (a shoulder, a groove, a
 * second ring), the gap closes at some r and δ; the function returns that pair.
 *
 * A gap may be negative by a thousandth of the depth. Raising the profile by ε where the gap is
 * negative makes the law exact, so the true force is between F(δ) and F(δ+ε): the tolerance causes
 * an error of at most two thousandths. Without the tolerance every concave corner of a sampled
 * profile would end the law, since g dips beyond it by as little as the square of the spacing.
 *
 * `kinks`: radii, ascending, at which g is not analytic. g is sampled between them at 500 points or
 * more. The depth found is accurate to about 1e-3.
 */
PALPATE_EXPORT DepthLimit findDepthLimit(const std::function<double(double)>& profile,
  const std::function<double(double)>& reducedProfile, const std::vector<double>& kinks,
  double outer);
} // namespace palpate

#endif
