// SPDX-License-Identifier: BSD-3-Clause
#ifndef RoundSteps_h
#define RoundSteps_h

#include <cmath>

namespace palpate
{
/// Returns the smallest step of the form 1, 2 or 5 times a power of ten that divides `span` into at
/// most `steps` parts.
inline double roundStep(double span, int steps)
{
  const double least = span / steps;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  const double share = least / decade * (1.0 - 1e-9); // the factor allows for rounding
  return decade * (share <= 1.0 ? 1.0 : share <= 2.0 ? 2.0 : share <= 5.0 ? 5.0 : 10.0);
}

/// Returns the number of labels, at most 11, of a colour bar from 0 to `end` > 0. The step between
/// the labels is 1, 2 or 5 times a power of ten. If no such step divides the bar evenly, there are
/// five labels.
inline int labelsOfBar(double end)
{
  for (const int most : { 6, 8, 10 })
  {
    const double count = end / roundStep(end, most);
    if (std::abs(count - std::round(count)) < 1e-6)
    {
      return static_cast<int>(std::round(count)) + 1;
    }
  }
  return 5;
}
} // namespace palpate

#endif
