// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/SphereTool.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Returns the solution w > 0 of w tanh w = depth, by Newton's method. The initial value is the
/// series of w² in the depth. At large depths it follows from tanh w ≈ 1.
double solveDepth(double depth)
{
  double w = depth < 1.0 ? std::sqrt(depth * (1.0 + depth * (1.0 / 3.0 + depth * (4.0 / 45.0))))
                         : depth * (1.0 + 2.0 * std::exp(-2.0 * depth));
  for (int iteration = 0; iteration < 20; ++iteration)
  {
    const double t = std::tanh(w);
    const double step = (w * t - depth) / (t + w * (1.0 - t * t));
    w -= step;
    if (!(std::abs(step) > 1e-8 * w))
    {
      break; // the size of the next step would be about the square of this step
    }
  }
  return w;
}
} // namespace

SphereTool::SphereTool(double radius)
  : Radius(radius)
{
}

std::string SphereTool::specification() const
{
  return formatTool("sphere", { this->Radius });
}

double SphereTool::profile(double r) const
{
  // R - √(R²-r²), written without cancellation near the tip.
  return r > this->Radius
    ? Infinity
    : r * r / (this->Radius + std::sqrt((this->Radius - r) * (this->Radius + r)));
}

double SphereTool::depthAtStrain(double ratio) const
{
  return this->depthAtContactRadius(ratio * this->Radius);
}

double SphereTool::depthAtContactRadius(double a) const
{
  return a >= this->Radius ? Infinity : this->reducedProfile(a);
}

double SphereTool::radiusAt(double deflection) const
{
  return this->Radius * std::tanh(solveDepth(deflection / this->Radius));
}

double SphereTool::forcePerModulus(double a, double deflection) const
{
  const double t = a / this->Radius;
  const double w = deflection / a;
  double bracket = (t * t + 1.0) * w - t;
  if (t < 0.1)
  {
    // The terms in the bracket cancel to 4/3 t³. Therefore the series Σ [1/(2k+1) + 1/(2k-1)]
    // t^(2k+1) is summed instead.
    bracket = 0.0;
    for (int k = 9; k >= 1; --k)
    {
      bracket = bracket * t * t + 1.0 / (2 * k + 1) + 1.0 / (2 * k - 1);
    }
    bracket *= t * t * t;
  }
  return this->Radius * this->Radius * bracket;
}

double SphereTool::reducedProfile(double x) const
{
  return x * std::atanh(x / this->Radius);
}

double SphereTool::reducedSlope(double x) const
{
  const double t = x / this->Radius;
  return std::atanh(t) + t / ((1.0 - t) * (1.0 + t));
}
} // namespace palpate
