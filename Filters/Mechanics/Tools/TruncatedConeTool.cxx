// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/TruncatedConeTool.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Numerics/IncreasingRoot.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
TruncatedConeTool::TruncatedConeTool(double radius, double halfAngle)
  : Edge(radius)
  , HalfAngle(halfAngle)
  , Slope(1.0 / std::tan(halfAngle * Pi / 180.0))
{
}

std::string TruncatedConeTool::specification() const
{
  return formatTool("truncated", { this->Edge.radius(), this->HalfAngle });
}

double TruncatedConeTool::profile(double r) const
{
  return std::isnan(r) ? r : this->Slope * std::max(0.0, r - this->Edge.radius());
}

double TruncatedConeTool::depthAtStrain(double ratio) const
{
  // δ/a = A cot α, A < π/2.
  const double angle = ratio / this->Slope;
  return angle >= 0.5 * Pi ? Infinity : ratio * this->Edge.radius() / std::cos(angle);
}

double TruncatedConeTool::reducedProfile(double x) const
{
  return std::isnan(x) ? x : this->Slope * this->Edge.reducedProfile(x);
}

double TruncatedConeTool::reducedSlope(double x) const
{
  return this->Slope * this->Edge.reducedSlope(x);
}

double TruncatedConeTool::radiusAt(double deflection) const
{
  // With t = tan A: δ tan α/b = √(1+t²) arctan t, which is convex and never less than t.
  const double b = this->Edge.radius();
  const double depth = deflection / (this->Slope * b);
  const double t = increasingRoot(
    [depth](double at)
    {
      const double secant = std::sqrt(1.0 + at * at);
      const double angle = std::atan(at);
      return ValueAndSlope{ secant * angle - depth, (1.0 + at * angle) / secant };
    },
    0.0, 2.0 * depth, depth);
  return b * std::sqrt(1.0 + t * t);
}

double TruncatedConeTool::forcePerModulus(double a, double deflection) const
{
  // The angle is computed from δ by a A cot α = δ, so that it remains accurate if a was rounded to
  // b.
  return a *
    (deflection + this->Slope * this->Edge.radius() * std::sin(deflection / (this->Slope * a)));
}

double TruncatedConeTool::pressurePerModulus(double r, double a, double) const
{
  return this->Slope * this->Edge.pressure(r, a);
}

double TruncatedConeTool::loadInside(double r, double a, double) const
{
  return this->Slope * this->Edge.loadInside(r, a);
}
} // namespace palpate
