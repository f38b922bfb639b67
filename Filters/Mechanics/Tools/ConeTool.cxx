// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/ConeTool.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <cmath>

namespace palpate
{
ConeTool::ConeTool(double halfAngle)
  : HalfAngle(halfAngle)
  , Slope(1.0 / std::tan(halfAngle * Pi / 180.0))
{
}

std::string ConeTool::specification() const
{
  return formatTool("cone", { this->HalfAngle });
}

double ConeTool::profile(double r) const
{
  return r * this->Slope;
}

double ConeTool::depthAtStrain(double ratio) const
{
  return std::isnan(ratio) ? ratio : 0.5 * Pi * this->Slope > ratio ? 0.0 : Infinity;
}

double ConeTool::depthAtContactRadius(double a) const
{
  return this->reducedProfile(a);
}

double ConeTool::radiusAt(double deflection) const
{
  return 2.0 * deflection / (Pi * this->Slope);
}

double ConeTool::forcePerModulus(double, double deflection) const
{
  return 2.0 / (Pi * this->Slope) * deflection * deflection;
}

double ConeTool::pressurePerModulus(double r, double a, double) const
{
  return r > 0.0 ? 0.5 * this->Slope * std::acosh(a / r) : Infinity;
}

double ConeTool::normalDisplacementOutside(double r, double a, double) const
{
  // √(r²-a²) - r = -a²/(r + √(r²-a²)) stays accurate at large r.
  const double root = std::sqrt(r - a) * std::sqrt(r + a);
  return this->Slope * a * (std::asin(a / r) - a / (r + root));
}

double ConeTool::loadInside(double r, double a, double deflection) const
{
  const double root = std::sqrt((a - r) * (a + r));
  const double q = (r / a) * (r / a);
  return this->forcePerModulus(a, deflection) * q * (std::acosh(a / r) + a / (a + root));
}

double ConeTool::reducedProfile(double x) const
{
  return 0.5 * Pi * this->Slope * x;
}

double ConeTool::reducedSlope(double) const
{
  return 0.5 * Pi * this->Slope;
}
} // namespace palpate
