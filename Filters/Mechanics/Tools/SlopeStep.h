// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SlopeStep_h
#define palpate_SlopeStep_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * The profile f = max(r-b, 0), whose slope increases from 0 to 1 at radius b >= 0. Truncated cones
 * and piecewise linear profiles are sums of such profiles. At equal contact radius, the results for
 * a sum of profiles (reduced profile, pressure, displacement, load) are the sums of the results for
 * each profile.
 *
 *   g(x) = x A, A = arccos(b/x), x > b;  ∫_0^a g dx = (a²A - b q)/2, q = √(a²-b²)
 * (Popov and Hess 2015). b = 0 is the cone. Results are per unit reduced modulus.
 */
class PALPATE_EXPORT SlopeStep
{
public:
  explicit SlopeStep(double radius)
    : Radius(radius)
  {
  }
  double radius() const noexcept { return this->Radius; }

  double reducedProfile(double x) const;
  double reducedSlope(double x) const;
  /// Returns ∫_0^a g dx, mm².
  double reducedIntegral(double a) const;

  /// Returns the pressure at 0 <= r <= a, dimensionless; +inf at r = b.
  double pressure(double r, double a) const;
  /// Returns u_z at r > a, mm, for the depth δ = g(a).
  double normalDisplacementOutside(double r, double a) const;
  /// Returns the load within the radius r at 0 < r < a, mm².
  double loadInside(double r, double a) const;

private:
  double Radius;
};
} // namespace palpate

#endif
