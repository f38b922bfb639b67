// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/AxisymmetricTool.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/DimensionalityReduction.h"

#include <cmath>
#include <sstream>

namespace palpate
{
std::string AxisymmetricTool::checkDepth(double deflection) const
{
  const DepthLimit limit = this->depthLimit();
  if (!(deflection > limit.depth))
  {
    return {};
  }
  std::ostringstream text;
  text << "at a deflection of " << deflection
       << " mm this tool touches the body again at r = " << limit.radius
       << " mm, outside the circle of contact; its law holds to " << limit.depth << " mm";
  return text.str();
}

IndentationPoint AxisymmetricTool::evaluate(double deflection, double reducedModulus) const
{
  if (!(deflection > 0.0 && this->answers(deflection)))
  {
    const double none = deflection <= 0.0 ? 0.0 : NotANumber;
    return { none, none, none };
  }
  const double a = this->radiusAt(deflection);
  return { reducedModulus * this->forcePerModulus(a, deflection), 2.0 * reducedModulus * a, a };
}

double AxisymmetricTool::contactRadius(double deflection) const
{
  if (!(deflection > 0.0 && this->answers(deflection)))
  {
    return deflection <= 0.0 ? 0.0 : NotANumber;
  }
  return this->radiusAt(deflection);
}

double AxisymmetricTool::force(double deflection, double reducedModulus) const
{
  return this->evaluate(deflection, reducedModulus).force;
}

double AxisymmetricTool::stiffness(double deflection, double reducedModulus) const
{
  if (!(deflection > 0.0 && this->answers(deflection)))
  {
    return deflection <= 0.0 ? 0.0 : NotANumber;
  }
  return 2.0 * reducedModulus * this->radiusAt(deflection);
}

double AxisymmetricTool::pressure(double r, double deflection, double reducedModulus) const
{
  if (!this->answers(deflection) || !(r >= 0.0))
  {
    return NotANumber;
  }
  const double a = this->contactRadius(deflection);
  if (deflection <= 0.0 || r > a || (r == a && a < this->largestContactRadius()))
  {
    return 0.0;
  }
  if (this->isStillFlat(a)) // the contact is that of the flat end, within rounding
  {
    return reducedModulus * deflection / (Pi * std::sqrt((a - r) * (a + r)));
  }
  return reducedModulus * this->pressurePerModulus(r, a, deflection);
}

SurfaceDisplacement AxisymmetricTool::surfaceDisplacement(
  double r, double deflection, double poissonRatio) const
{
  if (!this->answers(deflection) || !(r >= 0.0) || std::isnan(poissonRatio))
  {
    return { NotANumber, NotANumber };
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
  // A circular load displaces the surface inward. The displacement is proportional to the load
  // within the radius r (Johnson 1985, eq. 3.18).
  const double load = r >= a ? this->forcePerModulus(a, deflection)
    : this->isStillFlat(a)   ? 2.0 * deflection * r * r / (a + std::sqrt((a - r) * (a + r)))
                             : this->loadInside(r, a, deflection);
  const double radial = -(1.0 - 2.0 * poissonRatio) / (2.0 * Pi * (1.0 - poissonRatio)) * load / r;
  return { radial, normal };
}

double AxisymmetricTool::rimStep(double a, double deflection) const
{
  return a < this->largestContactRadius() ? 0.0 : deflection - this->reducedProfile(a);
}

double AxisymmetricTool::pressurePerModulus(double r, double a, double deflection) const
{
  return reduction::pressure([this](double x) { return this->reducedSlope(x); }, r, a,
    this->rimStep(a, deflection), this->kinks());
}

double AxisymmetricTool::normalDisplacementOutside(double r, double a, double deflection) const
{
  return reduction::normalDisplacementOutside(
    [this](double x) { return this->reducedProfile(x); }, r, a, deflection, this->kinks());
}

double AxisymmetricTool::loadInside(double r, double a, double deflection) const
{
  return reduction::loadInside([this](double x) { return this->reducedSlope(x); }, r, a,
    this->rimStep(a, deflection), this->kinks());
}
} // namespace palpate
