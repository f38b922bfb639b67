// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/ParaboloidTool.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <cmath>

namespace palpate
{
ParaboloidTool::ParaboloidTool(double radius)
  : Radius(radius)
{
}

std::string ParaboloidTool::specification() const
{
  return formatTool("paraboloid", { this->Radius });
}

double ParaboloidTool::profile(double r) const
{
  return r * r / (2.0 * this->Radius);
}

double ParaboloidTool::depthAtStrain(double ratio) const
{
  return ratio * ratio * this->Radius;
}

double ParaboloidTool::depthAtContactRadius(double a) const
{
  return this->reducedProfile(a);
}

double ParaboloidTool::radiusAt(double deflection) const
{
  return std::sqrt(this->Radius * deflection);
}

double ParaboloidTool::forcePerModulus(double a, double deflection) const
{
  return 4.0 / 3.0 * deflection * a;
}

double ParaboloidTool::pressurePerModulus(double r, double a, double) const
{
  return 2.0 / (Pi * this->Radius) * std::sqrt((a - r) * (a + r));
}

double ParaboloidTool::normalDisplacementOutside(double r, double a, double) const
{
  // [(2a²-r²) asin(a/r) + a√(r²-a²)]/(πR). At large r the terms cancel to 4a³/3r. With t =
  // asin(a/r) the bracket is r² [t (2 sin²t - 1) + sin t cos t], whose series starts at 4/3 t³.
  const double t = std::asin(a / r);
  if (t < 0.05)
  {
    const double rt = r * t;
    const double t2 = t * t;
    return rt * rt * t * (4.0 / 3.0 - t2 * (8.0 / 15.0 - t2 * (8.0 / 105.0 - t2 * 16.0 / 2835.0))) /
      (Pi * this->Radius);
  }
  return r * r * (0.5 * std::sin(2.0 * t) - t * std::cos(2.0 * t)) / (Pi * this->Radius);
}

double ParaboloidTool::loadInside(double r, double a, double deflection) const
{
  // F [1 - (1-q)^1.5] with q = (r/a)², written so that there is no cancellation at small r.
  const double q = (r / a) * (r / a);
  return -this->forcePerModulus(a, deflection) * std::expm1(1.5 * std::log1p(-q));
}
} // namespace palpate
