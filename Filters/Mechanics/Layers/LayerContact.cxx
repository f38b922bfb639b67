// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
// Relative error of the depth. The error of the force is smaller, because the force is stationary
// in a.
constexpr double DepthTolerance = 1e-13;
} // namespace

LayerContact::LayerContact(
  const AxisymmetricTool& tool, std::shared_ptr<const LayerKernel> kernel, double thickness)
  : Tool(tool)
  , Kernel(std::move(kernel))
  , Thickness(thickness)
  , Quadrature(tool)
  , SmallestRadius(tool.smallestContactRadius())
{
  const double answered = LayerKernel::LargestRatio * thickness;
  const double wall = tool.largestContactRadius();
  this->LargestRadius = std::min(wall, answered);
  // At the wall itself g may be infinite. Therefore the largest depth is evaluated at a slightly
  // smaller radius.
  this->LargestDepth = wall <= this->SmallestRadius ? 0.0
    : wall <= answered ? this->contactAt(std::nextafter(wall, 0.0)).depth
                       : this->contactAt(answered).depth;
  this->Deepest = wall <= answered    ? Infinity
    : this->SmallestRadius > answered ? 0.0
                                      : this->LargestDepth;
}

LayerContact::Contact LayerContact::contactAt(double a) const
{
  const LayerKernel::Solution solution = this->Kernel->at(a / this->Thickness);
  const LayerKernel::Samples& weights = LayerKernel::weights();
  double resolvent = 0.0; // ∫ Γ g
  double profile = 0.0;   // ∫ y₁ g
  if (this->Quadrature.kinkedBelow(a))
  {
    this->Quadrature.visit(a,
      [&](double x, double weight, double g)
      {
        resolvent += weight * g * LayerKernel::interpolate(solution.resolvent, x / a) / a;
        profile += weight * g * LayerKernel::interpolate(solution.flat, x / a);
      });
  }
  else
  {
    for (int i = 0; i < LayerKernel::NodeCount; ++i)
    {
      const double g = weights[i] * this->Tool.reducedProfile(a * LayerKernel::nodes()[i]);
      resolvent += g * solution.resolvent[i];
      profile += g * solution.flat[i] * a;
    }
  }
  const double rim = 1.0 - (weights * solution.resolvent).sum();
  return { (this->Tool.reducedProfile(a) - resolvent) / rim, a * (weights * solution.flat).sum(),
    profile };
}

/// Returns the contact radius for δ > 0; NaN beyond the validity of the law.
double LayerContact::solveRadius(double deflection, Contact& contact) const
{
  if (deflection >= this->LargestDepth)
  {
    contact = this->contactAt(std::nextafter(this->LargestRadius, 0.0));
    return deflection <= this->Deepest ? this->LargestRadius : NotANumber;
  }
  // Secant steps for log δ as a function of log a, which is nearly linear for every tool. Two
  // bounds limit the steps.
  double below = this->SmallestRadius;
  double above = this->LargestRadius;
  const auto inside = [&](double a) {
    return a > below && a < above ? a : below > 0.0 ? 0.5 * (below + above) : 0.1 * above;
  };
  double a = inside(this->Tool.contactRadius(deflection));
  double lastA = 0.0;
  double lastError = 0.0;
  for (int iteration = 0; iteration < 200; ++iteration)
  {
    contact = this->contactAt(a);
    const double error = std::log(contact.depth / deflection);
    if (!(std::abs(error) > DepthTolerance) || !(above - below > 1e-15 * above))
    {
      break;
    }
    (error > 0.0 ? above : below) = a;
    const double slope = lastA > 0.0     ? (error - lastError) / std::log(a / lastA)
      : this->Tool.forceExponent() > 1.0 ? 1.0 / (this->Tool.forceExponent() - 1.0)
                                         : 1.0;
    lastA = a;
    lastError = error;
    const double next = a * std::exp(-error / slope);
    a = next > below && next < above ? next : 0.5 * (below + above);
  }
  return a;
}

IndentationPoint LayerContact::evaluate(double deflection, double reducedModulus) const
{
  if (!(deflection > 0.0))
  {
    const double none = std::isnan(deflection) ? NotANumber : 0.0;
    return { none, none, none };
  }
  Contact contact{};
  const double a = this->solveRadius(deflection, contact);
  if (std::isnan(a))
  {
    return { NotANumber, NotANumber, NotANumber };
  }
  const double twice = 2.0 * reducedModulus;
  return { twice * (contact.flat * deflection - contact.profile), twice * contact.flat, a };
}

double LayerContact::contactRadius(double deflection) const
{
  return this->evaluate(deflection, 1.0).contactRadius;
}

double LayerContact::depthAtContactRadius(double a) const
{
  if (!(a >= 0.0) || a > LayerKernel::LargestRatio * this->Thickness)
  {
    return NotANumber;
  }
  if (a >= this->Tool.largestContactRadius() && a > this->SmallestRadius)
  {
    return Infinity;
  }
  return a <= this->SmallestRadius ? 0.0 : this->contactAt(a).depth;
}
} // namespace palpate
