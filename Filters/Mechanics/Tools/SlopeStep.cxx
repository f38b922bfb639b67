// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/SlopeStep.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/DimensionalityReduction.h"

#include <cmath>

namespace palpate
{
double SlopeStep::reducedProfile(double x) const
{
  const double b = this->Radius;
  return x > b ? x * std::atan2(std::sqrt((x - b) * (x + b)), b) : 0.0;
}

double SlopeStep::reducedSlope(double x) const
{
  const double b = this->Radius;
  if (b == 0.0)
  {
    return 0.5 * Pi;
  }
  const double q = std::sqrt((x - b) * (x + b));
  return x > b ? std::atan2(q, b) + b / q : 0.0;
}

double SlopeStep::reducedIntegral(double a) const
{
  const double b = this->Radius;
  if (!(a > b))
  {
    return 0.0;
  }
  const double q = std::sqrt((a - b) * (a + b));
  return 0.5 * (a * a * std::atan2(q, b) - b * q);
}

double SlopeStep::pressure(double r, double a) const
{
  const double b = this->Radius;
  if (a <= b)
  {
    return 0.0;
  }
  if (r == b)
  {
    return Infinity;
  }
  if (b == 0.0)
  {
    return 0.5 * std::acosh(a / r);
  }
  return reduction::pressure([this](double x) { return this->reducedSlope(x); }, r, a, 0.0, { b });
}

double SlopeStep::normalDisplacementOutside(double r, double a) const
{
  const double b = this->Radius;
  if (a <= b)
  {
    return 0.0;
  }
  if (b == 0.0)
  {
    // √(r²-a²) - r = -a²/(r + √(r²-a²)) stays accurate at large r.
    const double root = std::sqrt(r - a) * std::sqrt(r + a);
    return a * (std::asin(a / r) - a / (r + root));
  }
  return reduction::normalDisplacementOutside(
    [this](double x) { return this->reducedProfile(x); }, r, a, this->reducedProfile(a), { b });
}

double SlopeStep::loadInside(double r, double a) const
{
  const double b = this->Radius;
  if (a <= b)
  {
    return 0.0;
  }
  if (b == 0.0)
  {
    const double root = std::sqrt((a - r) * (a + r));
    return 0.5 * Pi * r * r * (std::acosh(a / r) + a / (a + root));
  }
  return reduction::loadInside(
    [this](double x) { return this->reducedSlope(x); }, r, a, 0.0, { b });
}
} // namespace palpate
