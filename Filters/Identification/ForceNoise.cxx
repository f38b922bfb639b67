// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/ForceNoise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
// 1/Φ⁻¹(3/4); ratio of standard deviation to median for normal noise.
constexpr double DeviationPerMedian = 1.482602218505602;
// Fraction of the range of depths. Readings whose depths differ by less count as readings at equal
// depth.
constexpr double TieShare = 1e-9;

/// Returns a linear combination of four readings that is 0 for a parabola, scaled to the noise of
/// one reading.
double residual(const double* x, const double* y, double tie)
{
  for (int i = 0; i < 3; ++i)
  {
    if (x[i + 1] - x[i] <= tie)
    {
      return (y[i + 1] - y[i]) / std::sqrt(2.0);
    }
  }
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    double weight = 1.0;
    for (int j = 0; j < 4; ++j)
    {
      weight *= j == i ? 1.0 : (x[3] - x[0]) / (x[i] - x[j]);
    }
    sum += weight * y[i];
    squares += weight * weight;
  }
  return sum / std::sqrt(squares);
}
} // namespace

ForceNoise estimateForceNoise(
  const std::vector<double>& deflection, const std::vector<double>& force)
{
  if (deflection.size() < 4)
  {
    return { std::numeric_limits<double>::quiet_NaN(), 0.0 };
  }
  const double tie = TieShare * (deflection.back() - deflection.front());
  std::vector<double> residuals;
  for (std::size_t i = 0; i + 4 <= deflection.size(); ++i)
  {
    residuals.push_back(std::abs(residual(&deflection[i], &force[i], tie)));
  }
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), middle, residuals.end());
  return { DeviationPerMedian * *middle, 0.25 * static_cast<double>(deflection.size()) };
}
} // namespace palpate
