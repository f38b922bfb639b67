// SPDX-License-Identifier: BSD-3-Clause
#include "DimensionalityReduction.h"

#include "GaussLegendre.h"

#include <cmath>

namespace palpate::reduction
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
}

double pressure(const Function& slope, double r, double a, double step)
{
  // x² = r² + t² removes the root at x = r: dx/√(x²-r²) = dt/x.
  const double end = std::sqrt((a - r) * (a + r));
  double sum = GaussLegendre::standard().integrate(0.0, end,
    [&](double t)
    {
      const double x = std::sqrt(r * r + t * t);
      return slope(x) / x;
    });
  if (step > 0.0)
  {
    sum += step / end;
  }
  return sum / Pi;
}

double normalDisplacementOutside(const Function& profile, double r, double a, double deflection)
{
  // x = r sin θ removes the root at x = r.
  const double end = std::asin(a / r);
  const double integral = GaussLegendre::standard().integrate(
    0.0, end, [&](double theta) { return profile(r * std::sin(theta)); });
  return 2.0 / Pi * (deflection * end - integral);
}

double loadInside(const Function& profile, const Function& slope, double r, double a, double step)
{
  const GaussLegendre& rule = GaussLegendre::standard();
  const double core = r * profile(r) - rule.integrate(0.0, r, profile);
  // Outside r: ∫_r^a g'(x) (x - √(x²-r²)) dx with x = r cosh φ.
  const double end = std::acosh(a / r);
  const double ring = rule.integrate(0.0, end,
    [&](double phi)
    { return slope(r * std::cosh(phi)) * r * r * std::exp(-phi) * std::sinh(phi); });
  const double flat = step > 0.0 ? step * r * r / (a + std::sqrt((a - r) * (a + r))) : 0.0;
  return 2.0 * (core + ring + flat);
}
} // namespace palpate::reduction
