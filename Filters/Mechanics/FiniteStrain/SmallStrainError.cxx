// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/FiniteStrain/SmallStrainError.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
/// Returns the value at `ratio` of the quadratic through the values at ν = 0.3, 0.45 and 0.495. It
/// is constant below 0.3 and above 0.495.
double overRatio(const std::array<double, 3>& value, double ratio)
{
  constexpr std::array<double, 3> node = { 0.3, 0.45, 0.495 };
  const double x = std::clamp(ratio, node[0], node[2]);
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    sum += value[i] * (x - node[j]) / (node[i] - node[j]) * (x - node[k]) / (node[i] - node[k]);
  }
  return sum;
}
} // namespace

double smallStrainError(
  double pressure, double poissonRatio, double depthOverThickness, double radiusOverThickness)
{
  // A measure of compressibility, which is 0 at ν = ½.
  const double n = (1.0 - 2.0 * poissonRatio) / (1.0 - poissonRatio);
  if (!(depthOverThickness > 0.0))
  {
    // The residual of the estimate is of second order: 0.009 at s = 0.3, and 0.033 at 0.55. For ν
    // below 0.3 the slope is that of the sphere's table at ν = 0.
    constexpr double atLeast = 4.0 / 7.0;
    const double slope = -0.148 + 0.61 * n + 0.8 * std::max(0.0, n - atLeast);
    return std::abs(slope) * pressure +
      (0.1 + 0.8 * std::max(0.0, n - atLeast)) * pressure * pressure;
  }
  const double k = overRatio({ 0.182, -0.104, -0.185 }, poissonRatio);
  const double b = overRatio({ 0.668, 0.480, 0.275 }, poissonRatio);
  const double layer = b * depthOverThickness * radiusOverThickness / (0.5 + radiusOverThickness);
  return std::abs(k * pressure + layer) + 0.1 * pressure * pressure + 0.05 * depthOverThickness;
}
} // namespace palpate
