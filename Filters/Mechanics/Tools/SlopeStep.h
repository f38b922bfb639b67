// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SlopeStep_h
#define palpate_SlopeStep_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * The profile f = max(r-b, 0), whose slope steps from 0 to 1 at radius b >= 0. Truncated cones and
 * piecewise linear profiles are sums of such steps. At equal contact radius the results of a sum of
 * profiles (reduced profile, pressure, displacement, load) are the sums of the results of the
 * profiles.
 *
 *   g(x) = x A, A = arccos(b/x), x > b;  ∫_0^a g dx = (a²A - b q)/2, q = √(a²-b²)
 * (Popov and Hess 2015). b = 0 is the cone. Results per unit reduced modulus.
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
  /// ∫_0^a g dx, mm².
  double reducedIntegral(double a) const;

  /// Pressure at 0 <= r <= a, without unit; +inf at r = b.
  double pressure(double r, double a) const;
  /// u_z at r > a, mm, for the depth δ = g(a).
  double normalDisplacementOutside(double r, double a) const;
  /// Load within the radius r at 0 < r < a, mm².
  double loadInside(double r, double a) const;

private:
  double Radius;
};
} // namespace palpate

#endif
