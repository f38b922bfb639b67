// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/FlatTool.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <cmath>

namespace palpate
{
FlatTool::FlatTool(double radius)
  : Radius(radius)
{
}

std::string FlatTool::specification() const
{
  return formatTool("flat", { this->Radius });
}

double FlatTool::profile(double r) const
{
  return std::isnan(r) ? r : r <= this->Radius ? 0.0 : Infinity;
}

double FlatTool::depthAtStrain(double ratio) const
{
  return ratio * this->Radius;
}

double FlatTool::depthAtContactRadius(double a) const
{
  return std::isnan(a) ? a : a <= this->Radius ? 0.0 : Infinity;
}

double FlatTool::radiusAt(double) const
{
  return this->Radius;
}

double FlatTool::forcePerModulus(double a, double deflection) const
{
  return 2.0 * a * deflection;
}

double FlatTool::pressurePerModulus(double r, double a, double deflection) const
{
  return deflection / (Pi * std::sqrt((a - r) * (a + r)));
}

double FlatTool::normalDisplacementOutside(double r, double a, double deflection) const
{
  return 2.0 * deflection / Pi * std::asin(a / r);
}

double FlatTool::loadInside(double r, double a, double deflection) const
{
  // F (1 - √(1-q)) with q = (r/a)², written so that there is no cancellation at small r.
  const double q = (r / a) * (r / a);
  return this->forcePerModulus(a, deflection) * q / (1.0 + std::sqrt(1.0 - q));
}
} // namespace palpate
