// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/PowerLawTool.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <cmath>

namespace palpate
{
PowerLawTool::PowerLawTool(double exponent, double coefficient)
  : Exponent(exponent)
  , Coefficient(coefficient)
  , ReducedCoefficient(coefficient * 0.5 * std::sqrt(Pi) * exponent * std::tgamma(0.5 * exponent) /
      std::tgamma(0.5 * (exponent + 1.0)))
{
}

std::string PowerLawTool::specification() const
{
  return formatTool("power", { this->Exponent, this->Coefficient });
}

double PowerLawTool::profile(double r) const
{
  return this->Coefficient * std::pow(r, this->Exponent);
}

double PowerLawTool::depthAtStrain(double ratio) const
{
  if (this->Exponent == 1.0)
  {
    return std::isnan(ratio) ? ratio : this->ReducedCoefficient > ratio ? 0.0 : Infinity;
  }
  return ratio * std::pow(ratio / this->ReducedCoefficient, 1.0 / (this->Exponent - 1.0));
}

double PowerLawTool::reducedProfile(double x) const
{
  return this->ReducedCoefficient * std::pow(x, this->Exponent);
}

double PowerLawTool::reducedSlope(double x) const
{
  return this->Exponent * this->ReducedCoefficient * std::pow(x, this->Exponent - 1.0);
}

double PowerLawTool::radiusAt(double deflection) const
{
  return std::pow(deflection / this->ReducedCoefficient, 1.0 / this->Exponent);
}

double PowerLawTool::forcePerModulus(double a, double deflection) const
{
  return 2.0 * this->Exponent / (this->Exponent + 1.0) * a * deflection;
}

double PowerLawTool::pressurePerModulus(double r, double a, double deflection) const
{
  if (r == 0.0 && this->Exponent > 1.0)
  {
    // ∫_0^a g'(x)/x dx in closed form. Quadrature is accurate only for n above 5/4.
    return this->Exponent / (this->Exponent - 1.0) * deflection / (Pi * a);
  }
  return AxisymmetricTool::pressurePerModulus(r, a, deflection);
}
} // namespace palpate
