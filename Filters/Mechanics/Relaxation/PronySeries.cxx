// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Relaxation/PronySeries.h"

#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace palpate
{
namespace
{
/// Returns M(1; m+1; -x) = m ∫₀¹ e^(-x(1-v)) v^(m-1) dv, x >= 0.
double kummer(double m, double x)
{
  constexpr double far = 50.0;
  const double enough = std::numeric_limits<double>::epsilon();
  if (x > far)
  {
    // Asymptotic series m/x (1 - (m-1)/x (1 - (m-2)/x (1 - ...))), summed until it ends or its
    // terms become negligible.
    double sum = 0.0;
    double term = m / x;
    for (int k = 1; std::abs(term) > enough * std::abs(sum) && k < far; ++k)
    {
      sum += term;
      term *= -(m - k) / x;
    }
    return sum;
  }
  // Sums e^-x M(m; m+1; x), whose terms are all positive.
  double sum = 0.0;
  double term = 1.0;
  for (int k = 0; k < x || term > enough * sum; ++k)
  {
    sum += term * m / (m + k);
    term *= x / (k + 1);
  }
  return std::exp(-x) * sum;
}
} // namespace

std::string faultOfRelaxation(const PronySeries& series)
{
  if (series.count > PronySeries::LargestCount)
  {
    return joined("a relaxation has at most ", PronySeries::LargestCount,
      " branches, but there are ", series.count);
  }
  for (std::size_t i = 0; i < series.count; ++i)
  {
    if (!(series.strength[i] >= 0.0) || !std::isfinite(series.strength[i]))
    {
      return joined("the strength of relaxation ", i + 1,
        " must be finite and not negative, but is ", series.strength[i]);
    }
    if (!(series.time[i] > 0.0) || !std::isfinite(series.time[i]))
    {
      return joined(
        "the time of relaxation ", i + 1, " must be finite and above 0 s, but is ", series.time[i]);
    }
  }
  return {};
}

double relaxationAt(const PronySeries& series, double seconds)
{
  double sum = 1.0;
  for (std::size_t i = 0; i < series.count; ++i)
  {
    sum += series.strength[i] * std::exp(-seconds / series.time[i]);
  }
  return sum;
}

double rampFactor(const PronySeries& series, double exponent, double seconds)
{
  double sum = 1.0;
  for (std::size_t i = 0; i < series.count; ++i)
  {
    sum += series.strength[i] * kummer(exponent, seconds / series.time[i]);
  }
  return sum;
}

std::string parsePronySeries(const std::string& text, PronySeries& series)
{
  PronySeries read;
  std::string_view rest = text;
  while (!rest.empty())
  {
    const std::string_view pair = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), pair.size() + 1));
    const std::size_t colon = pair.find(':');
    double strength = 0.0;
    double time = 0.0;
    if (colon == std::string_view::npos || !readNumber(pair.substr(0, colon), strength) ||
      !readNumber(pair.substr(colon + 1), time))
    {
      return joined("'", pair, "' is not a relaxation, which is strength:seconds, e.g. 0.5:0.1");
    }
    if (read.count == PronySeries::LargestCount)
    {
      return joined("'", text, "' has more than ", PronySeries::LargestCount, " relaxations");
    }
    read.add(strength, time);
  }
  std::string fault = faultOfRelaxation(read);
  if (fault.empty())
  {
    series = read;
  }
  return fault;
}

std::string textOf(const PronySeries& series)
{
  std::string text;
  for (std::size_t i = 0; i < series.count; ++i)
  {
    text += (i > 0 ? "," : "") + shortestDecimals(series.strength[i]) + ":" +
      shortestDecimals(series.time[i]);
  }
  return text;
}
} // namespace palpate
