// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Coupling/CouplingLaw.h"

#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
/// Number of angles of the midpoint rule for ∫_0^{π/2} M(x sin φ) dφ. For this periodic function
/// the error is (e^(-8/x))^Angles, which is negligible at x = 40.
constexpr int Angles = 512;

/// Returns g at x, which may be negative (M is even).
double shareOf(const LayerKernel& kernel, double x)
{
  double sum = 0.0;
  for (int i = 0; i < Angles; ++i)
  {
    sum += kernel.normal(std::abs(x) * std::sin((i + 0.5) * 0.5 * Pi / Angles));
  }
  return 1.0 + x * sum / Angles;
}

/// Returns dg/dx by fourth-order differences. The error is 1e-9 for a function that varies over
/// lengths of 1.
double slopeOf(const LayerKernel& kernel, double x)
{
  constexpr double step = 0.01;
  const auto difference = [&](double by)
  { return shareOf(kernel, x + by) - shareOf(kernel, x - by); };
  return (8.0 * difference(step) - difference(2.0 * step)) / (12.0 * step);
}

/// Returns K/(2E*h) of a flat end of radius a on the layer. It is the same for any tool with the
/// contact radius a.
double stiffnessOf(const LayerKernel& kernel, double ratio)
{
  return ratio * (LayerKernel::weights() * kernel.at(ratio).flat).sum();
}

double ratioOf(const LayerKernel& kernel, double stiffness)
{
  double low = 0.0;
  double high = LayerKernel::LargestRatio;
  for (int i = 0; i < 40; ++i)
  {
    const double middle = 0.5 * (low + high);
    (stiffnessOf(kernel, middle) < stiffness ? low : high) = middle;
  }
  return high;
}
} // namespace

CouplingLaw::CouplingLaw(const LayerKernel& kernel)
{
  for (int k = 0; k < KnotCount; ++k)
  {
    const double rest = 1.0 - k / Places;
    const double x = k / Places / rest;
    this->Knots.push_back({ shareOf(kernel, x), slopeOf(kernel, x) / (rest * rest),
      k == 0 ? 0.0 : ratioOf(kernel, x) });
  }
}

CouplingLaw::Share CouplingLaw::at(double x) const noexcept
{
  if (this->Knots.empty())
  {
    return { 1.0, 0.0 };
  }
  const double place = Places * x / (1.0 + x);
  if (!(place < KnotCount - 1))
  {
    return { this->Knots.back().share, 0.0 };
  }
  const auto k = static_cast<std::size_t>(place);
  const CouplingKnot& lower = this->Knots[k];
  const CouplingKnot& upper = this->Knots[k + 1];
  const double t = place - static_cast<double>(k);
  const double rise = upper.share - lower.share;
  const double from = lower.slope / Places - rise;
  const double to = rise - upper.slope / Places;
  const double bend = t * (1.0 - t);
  const double byPlace = rise + (1.0 - 2.0 * t) * ((1.0 - t) * from + t * to) + bend * (to - from);
  return { lower.share + t * rise + bend * ((1.0 - t) * from + t * to),
    byPlace * Places / ((1.0 + x) * (1.0 + x)) };
}

double CouplingLaw::contactRadius(double stiffness, double modulus, double thickness) const noexcept
{
  if (this->Knots.empty())
  {
    return stiffness / (2.0 * modulus);
  }
  const double x = std::max(0.0, stiffness / (2.0 * modulus * thickness));
  const double place = std::min(Places * x / (1.0 + x), KnotCount - 1.001);
  const auto k = static_cast<std::size_t>(place);
  const double t = place - static_cast<double>(k);
  return thickness * ((1.0 - t) * this->Knots[k].ratio + t * this->Knots[k + 1].ratio);
}
} // namespace palpate
