// SPDX-License-Identifier: BSD-3-Clause
#include "AxisymmetricTool.h"

#include "DimensionalityReduction.h"

#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// δ - g(a): δ under a flat end; under a smooth rim 0, whatever rounding leaves of it.
double rimStep(double deflection, double reducedProfile)
{
  const double step = deflection - reducedProfile;
  return step > 1e-10 * deflection ? step : 0.0;
}
} // namespace

IndentationPoint AxisymmetricTool::evaluate(double deflection, double reducedModulus) const
{
  if (!(deflection > 0.0))
  {
    const double none = std::isnan(deflection) ? NaN : 0.0;
    return { none, none, none };
  }
  const double a = this->radiusAt(deflection);
  return { reducedModulus * this->forcePerModulus(a, deflection), 2.0 * reducedModulus * a, a };
}

double AxisymmetricTool::contactRadius(double deflection) const
{
  if (!(deflection > 0.0))
  {
    return std::isnan(deflection) ? NaN : 0.0;
  }
  return this->radiusAt(deflection);
}

double AxisymmetricTool::force(double deflection, double reducedModulus) const
{
  return this->evaluate(deflection, reducedModulus).force;
}

double AxisymmetricTool::stiffness(double deflection, double reducedModulus) const
{
  if (!(deflection > 0.0))
  {
    return std::isnan(deflection) ? NaN : 0.0;
  }
  return 2.0 * reducedModulus * this->radiusAt(deflection);
}

double AxisymmetricTool::pressure(double r, double deflection, double reducedModulus) const
{
  if (std::isnan(deflection) || !(r >= 0.0))
  {
    return NaN;
  }
  const double a = this->contactRadius(deflection);
  if (deflection <= 0.0 || r > a)
  {
    return 0.0;
  }
  return reducedModulus * this->pressurePerModulus(r, a, deflection);
}

SurfaceDisplacement AxisymmetricTool::surfaceDisplacement(
  double r, double deflection, double poissonsRatio) const
{
  if (std::isnan(deflection) || !(r >= 0.0) || std::isnan(poissonsRatio))
  {
    return { NaN, NaN };
  }
  if (deflection <= 0.0 || std::isinf(r))
  {
    return { 0.0, 0.0 };
  }
  const double a = this->radiusAt(deflection);
  const double normal =
    r <= a ? deflection - this->profile(r) : this->normalDisplacementOutside(r, a, deflection);
  if (r == 0.0)
  {
    return { 0.0, normal };
  }
  // Every circular load draws the surface inward by its load inside r (Johnson 1985, eq. 3.18).
  const double load =
    r < a ? this->loadInside(r, a, deflection) : this->forcePerModulus(a, deflection);
  const double radial =
    -(1.0 - 2.0 * poissonsRatio) / (2.0 * Pi * (1.0 - poissonsRatio)) * load / r;
  return { radial, normal };
}

double AxisymmetricTool::pressurePerModulus(double r, double a, double deflection) const
{
  return reduction::pressure([this](double x) { return this->reducedSlope(x); }, r, a,
    rimStep(deflection, this->reducedProfile(a)));
}

double AxisymmetricTool::normalDisplacementOutside(double r, double a, double deflection) const
{
  return reduction::normalDisplacementOutside(
    [this](double x) { return this->reducedProfile(x); }, r, a, deflection);
}

double AxisymmetricTool::loadInside(double r, double a, double deflection) const
{
  return reduction::loadInside([this](double x) { return this->reducedProfile(x); },
    [this](double x) { return this->reducedSlope(x); }, r, a,
    rimStep(deflection, this->reducedProfile(a)));
}
} // namespace palpate
