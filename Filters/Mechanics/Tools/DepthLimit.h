// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DepthLimit_h
#define palpate_DepthLimit_h

#include "Mechanics/PalpateExport.h"

#include <functional>
#include <limits>
#include <vector>

namespace palpate
{
/// The end of a half-space law. At depths beyond `depth`, the tool would also touch the body at
/// `radius`, outside the circle of contact. Both in mm; +inf and NaN if there is no such depth.
struct DepthLimit
{
  double depth = std::numeric_limits<double>::infinity();
  double radius = std::numeric_limits<double>::quiet_NaN();
};

/**
 * Returns the largest depth at which the profile f(r), r <= outer, touches a half-space in one full
 * circle.
 *
 * With the reduced profile g and g(a) = δ the gap outside the contact is
 *   f(r) - δ + (2/π) [δ asin(a/r) + ∫_0^a g dx/√(r²-x²) ... ] = (2/π) ∫_a^r (g-δ) dx/√(r²-x²),
 * which is never negative if g increases everywhere. If g decreases (at a shoulder, a groove, a
 * second ring), the gap closes at some r and δ, which are returned.
 *
 * The gap may be negative by up to a thousandth of the depth. If the profile is raised by ε where
 * the gap is negative, the law is exact. Therefore the true force is between F(δ) and F(δ+ε), and
 * the tolerance causes an error of at most two thousandths. Without the tolerance every concave
 * corner of a sampled profile would end the law, because beyond the corner g decreases by an amount
 * of the order of the squared spacing.
 *
 * `kinks` are the radii, ascending, at which g is not analytic. g is sampled between the kinks at
 * 500 points or more. The resulting depth is accurate to about 1e-3.
 */
PALPATE_EXPORT DepthLimit findDepthLimit(const std::function<double(double)>& profile,
  const std::function<double(double)>& reducedProfile, const std::vector<double>& kinks,
  double outer);
} // namespace palpate

#endif
