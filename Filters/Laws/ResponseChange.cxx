// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/ResponseChange.h"

#include "Contact/ResponseContract.h"
#include "Contact/ResponseSampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double StorageExponent = 1.0;
constexpr int BetweenSamples = 8;
// Relative difference above which one change counts as larger than another. The forces are stored
// as floats.
constexpr double LeastDifference = 1e-4;

FloatCurve curveOf(const ResponseSpans& spans, std::size_t i)
{
  const auto first = static_cast<std::size_t>(spans.samples) * i;
  return { spans.force + first, spans.stiffness + first };
}
} // namespace

ResponseChange largestChange(const ResponseSpans& changed, const ResponseSpans& usual,
  std::size_t i, double deepest, bool withinValidity)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr auto valid = static_cast<unsigned char>(ResponseStatus::Valid);
  ResponseChange largest{ nan, nan, nan };
  if (changed.status[i] != valid || usual.status[i] != valid)
  {
    return largest;
  }
  double end = deepest;
  for (const ResponseSpans* spans : { &changed, &usual })
  {
    end = std::min(end, static_cast<double>(spans->range[i]));
    end = withinValidity ? std::min(end, static_cast<double>(spans->validity[i])) : end;
  }
  const int samples = std::min(changed.samples, usual.samples);
  const ResponseSampling ofChanged(changed.samples, StorageExponent);
  const ResponseSampling ofUsual(usual.samples, StorageExponent);
  const auto depthAt = [&](int step)
  {
    const double root = static_cast<double>(step) / (BetweenSamples * samples);
    return end * root * root;
  };
  for (int step = BetweenSamples; end > 0.0 && step <= BetweenSamples * samples; ++step)
  {
    const double depth = depthAt(step);
    const ResponseValue with =
      ofChanged.evaluate(curveOf(changed, i), static_cast<double>(changed.range[i]), depth);
    const ResponseValue without =
      ofUsual.evaluate(curveOf(usual, i), static_cast<double>(usual.range[i]), depth);
    const double change = with.force / without.force - 1.0;
    if (std::isfinite(change) &&
      !(std::abs(change) <= (1.0 + LeastDifference) * std::abs(largest.force)))
    {
      largest = { change, with.stiffness / without.stiffness - 1.0, depth };
    }
  }
  return largest;
}
} // namespace palpate
