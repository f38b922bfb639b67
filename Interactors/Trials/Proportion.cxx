// SPDX-License-Identifier: BSD-3-Clause
#include "Trials/Proportion.h"

#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// Number of halvings that shortens an interval of length 80 to less than 1e-16.
constexpr int Halvings = 60;

/// Probability of at least `successes` in `trials`, each of which succeeds with the probability p,
/// in (0, 1). Terms are computed by logarithms, because the coefficients overflow for 1030 trials
/// and more.
double upperTail(int successes, int trials, double p)
{
  double sum = 0.0;
  for (int k = successes; k <= trials; ++k)
  {
    sum += std::exp(std::lgamma(trials + 1.0) - std::lgamma(k + 1.0) -
      std::lgamma(trials - k + 1.0) + k * std::log(p) + (trials - k) * std::log1p(-p));
  }
  return sum;
}

/// Returns the root of an increasing function.
template <class Function>
double rootBetween(double low, double high, const Function& function)
{
  for (int i = 0; i < Halvings; ++i)
  {
    const double middle = 0.5 * (low + high);
    (function(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}
} // namespace

Proportion proportionOf(int successes, int trials, double confidence)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Proportion result{ successes, trials, nan, nan, nan };
  if (successes < 0 || successes > trials || !(confidence > 0.0 && confidence < 1.0))
  {
    return result;
  }
  const double tail = 0.5 * (1.0 - confidence);
  result.share = trials == 0 ? 0.5 : static_cast<double>(successes) / trials;
  result.lower = successes == 0
    ? 0.0
    : rootBetween(0.0, 1.0, [&](double p) { return upperTail(successes, trials, p) - tail; });
  // The upper limit follows from the same tail for the failures, of which at least as many as
  // observed occur.
  result.upper = successes == trials ? 1.0
                                     : 1.0 -
      rootBetween(
        0.0, 1.0, [&](double q) { return upperTail(trials - successes, trials, q) - tail; });
  return result;
}

double normalQuantile(double p)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (p == 0.0 || p == 1.0)
  {
    return p == 0.0 ? -infinity : infinity;
  }
  if (!(p > 0.0 && p < 1.0))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  // erfc is 0 in double precision beyond 38 standard deviations.
  return rootBetween(
    -40.0, 40.0, [p](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)) - p; });
}
} // namespace palpate
