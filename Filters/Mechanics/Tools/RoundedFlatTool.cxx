// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/RoundedFlatTool.h"

#include "Mechanics/Numerics/IncreasingRoot.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Returns t - arctan t, without cancellation.
double tangentExcess(double t)
{
  if (!(t < 0.3))
  {
    return t - std::atan(t);
  }
  double sum = 0.0; // Σ (-1)^(k+1) t^(2k+1)/(2k+1)
  for (int k = 14; k >= 1; --k)
  {
    sum = 1.0 / (2 * k + 1) - t * t * sum;
  }
  return t * t * t * sum;
}

/// Returns 3 (t - arctan t) (1+t²) - t³, without cancellation.
double integralOfExcess(double t)
{
  if (!(t < 0.3))
  {
    return 3.0 * (t - std::atan(t)) * (1.0 + t * t) - t * t * t;
  }
  double sum = 0.0; // 6 Σ (-1)^k t^(2k+1)/(4k²-1), k >= 2
  for (int k = 15; k >= 2; --k)
  {
    sum = 1.0 / (4 * k * k - 1) - t * t * sum;
  }
  return 6.0 * t * t * t * t * t * sum;
}

/// Returns tan A for a contact radius a >= b, where A = arccos(b/a).
double tangent(double a, double b)
{
  return std::sqrt((a - b) * (a + b)) / b;
}
} // namespace

RoundedFlatTool::RoundedFlatTool(double radius, double edgeRadius)
  : Radius(radius)
  , EdgeRadius(edgeRadius)
{
}

std::string RoundedFlatTool::specification() const
{
  return formatTool("rounded", { this->Radius, this->EdgeRadius });
}

double RoundedFlatTool::profile(double r) const
{
  const double beyond = std::max(r - this->Radius, 0.0);
  return std::isnan(r) ? r : beyond * beyond / (2.0 * this->EdgeRadius);
}

double RoundedFlatTool::depthAtStrain(double ratio) const
{
  if (!(ratio > 0.0))
  {
    return std::isnan(ratio) ? ratio : 0.0;
  }
  // δ/a = (b/R_e) (t - arctan t). The term in parentheses is between t - π/2 and t; for small t it
  // is like t³/3.
  const double excess = ratio * this->EdgeRadius / this->Radius;
  const double t = increasingRoot(
    [excess](double at) {
      return ValueAndSlope{ tangentExcess(at) - excess, at * at / (1.0 + at * at) };
    },
    0.0, excess + 2.0 * std::cbrt(excess), excess + std::cbrt(3.0 * excess));
  return ratio * this->Radius * std::sqrt(1.0 + t * t);
}

double RoundedFlatTool::reducedProfile(double x) const
{
  if (!(x > this->Radius))
  {
    return std::isnan(x) ? x : 0.0;
  }
  return x * this->Radius / this->EdgeRadius * tangentExcess(tangent(x, this->Radius));
}

double RoundedFlatTool::reducedSlope(double x) const
{
  if (!(x > this->Radius))
  {
    return 0.0;
  }
  const double t = tangent(x, this->Radius);
  return this->Radius / this->EdgeRadius * (t + tangentExcess(t));
}

double RoundedFlatTool::radiusAt(double deflection) const
{
  // δ R_e/b² = √(1+t²) (t - arctan t): like t³/3 for small t, like t² for large t.
  const double depth = deflection * this->EdgeRadius / this->Radius / this->Radius;
  const double start = std::min(std::cbrt(3.0 * depth), 1.0 + std::sqrt(depth));
  const double t = increasingRoot(
    [depth](double at)
    {
      const double secant = std::sqrt(1.0 + at * at);
      const double excess = tangentExcess(at);
      return ValueAndSlope{ secant * excess - depth, at * (at + excess) / secant };
    },
    0.0, 2.0 + 2.0 * std::cbrt(3.0 * depth) + 2.0 * std::sqrt(depth), start);
  return this->Radius * std::sqrt(1.0 + t * t);
}

double RoundedFlatTool::forcePerModulus(double a, double deflection) const
{
  // The result is 2 (a δ - ∫ g dx). The integral is negligible if a was rounded to b.
  const double b = this->Radius;
  return 2.0 * a * deflection -
    b * (b * (b / (3.0 * this->EdgeRadius))) * integralOfExcess(tangent(a, b));
}
} // namespace palpate
