// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/BluntedConeTool.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Numerics/GaussLegendre.h"
#include "Mechanics/Numerics/IncreasingRoot.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <cmath>

namespace palpate
{
BluntedConeTool::BluntedConeTool(double radius, double halfAngle)
  : Radius(radius)
  , HalfAngle(halfAngle)
  , Cosine(std::sin((90.0 - halfAngle) * Pi / 180.0))
  , Sine(std::sin(halfAngle * Pi / 180.0))
  , Tangent(radius * this->Cosine)
  , Tip(radius)
{
}

std::string BluntedConeTool::specification() const
{
  return formatTool("blunted", { this->Radius, this->HalfAngle });
}

double BluntedConeTool::profile(double r) const
{
  const double b = this->Tangent;
  return r > b ? this->Tip.profile(b) + (r - b) * this->Cosine / this->Sine : this->Tip.profile(r);
}

double BluntedConeTool::depthAtStrain(double ratio) const
{
  return this->depthAtContactRadius(ratio * this->Radius);
}

/// L = ln[(R+x)/(R sin α+q)]. Also accurate if L is small, because R - R sin α is computed as b²/(R
/// + R sin α).
double BluntedConeTool::logarithm(double x, double q) const
{
  const double b = this->Tangent;
  const double end = this->Radius * this->Sine;
  return std::log1p((b * (b / (this->Radius + end)) + b * (b / (x + q))) / (end + q));
}

double BluntedConeTool::reducedProfile(double x) const
{
  const double b = this->Tangent;
  if (!(x > b))
  {
    return this->Tip.reducedProfile(x);
  }
  const double q = std::sqrt((x - b) * (x + b));
  return x * (this->logarithm(x, q) + this->Cosine / this->Sine * std::atan2(q, b));
}

/// Returns g' at x = √(b²+q²) > b.
double BluntedConeTool::slopeBehind(double x, double q) const
{
  const double b = this->Tangent;
  const double end = this->Radius * this->Sine;
  return this->logarithm(x, q) + x / (this->Radius + x) + (b * (b / end) - q) / (end + q) +
    this->Cosine / this->Sine * std::atan2(q, b);
}

double BluntedConeTool::reducedSlope(double x) const
{
  const double b = this->Tangent;
  if (!(x > b))
  {
    const double t = x / this->Radius;
    return std::atanh(t) + t / ((1.0 - t) * (1.0 + t));
  }
  return this->slopeBehind(x, std::sqrt((x - b) * (x + b)));
}

double BluntedConeTool::radiusAt(double deflection) const
{
  const double b = this->Tangent;
  if (deflection <= this->Tip.reducedProfile(b))
  {
    return this->Tip.contactRadius(deflection);
  }
  // The unknown is q. g increases at least as fast as that of a cone whose apex is at (b, g(b)): g
  // >= (π/2) c (x-b).
  const double slope = this->Cosine / this->Sine;
  const double high = b + 2.0 * deflection / (Pi * slope);
  const double q = increasingRoot(
    [&](double at)
    {
      const double x = std::hypot(b, at);
      const double value = x * (this->logarithm(x, at) + slope * std::atan2(at, b));
      return ValueAndSlope{ value - deflection, this->slopeBehind(x, at) * at / x };
    },
    0.0, 2.0 * high, high);
  return std::hypot(b, q);
}

double BluntedConeTool::forcePerModulus(double a, double deflection) const
{
  const double b = this->Tangent;
  if (a <= b)
  {
    return this->Tip.force(deflection, 1.0);
  }
  const double R = this->Radius;
  const double q = std::sqrt((a - b) * (a + b));
  double integral = 0.5 *
    ((a - R) * (a + R) * this->logarithm(a, q) + R * (a - q / this->Sine) +
      this->Cosine / this->Sine * a * a * std::atan2(q, b));
  if (integral < 1e-3 * R * a)
  {
    // The terms cancel if the tip is much wider than the contact. Then quadrature over u is used,
    // with x = b + (a-b) u².
    const double whole = this->Tip.reducedProfile(b);
    integral = b * whole - 0.5 * this->Tip.force(whole, 1.0) +
      GaussLegendre::standard().integrate(0.0, 1.0,
        [&](double u) { return this->reducedProfile(b + (a - b) * u * u) * 2.0 * (a - b) * u; });
  }
  return 2.0 * (a * deflection - integral);
}
} // namespace palpate
