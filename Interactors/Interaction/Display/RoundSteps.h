// SPDX-License-Identifier: BSD-3-Clause
#ifndef RoundSteps_h
#define RoundSteps_h

#include <cmath>

namespace palpate
{
/// The smallest of 1, 2, 5 times a power of ten that divides `span` into at most `steps` steps.
inline double roundStep(double span, int steps)
{
  const double least = span / steps;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  const double share = least / decade * (1.0 - 1e-9); // allows for rounding
  return decade * (share <= 1.0 ? 1.0 : share <= 2.0 ? 2.0 : share <= 5.0 ? 5.0 : 10.0);
}

/// The number of labels of a colour bar from 0 to `end` > 0, with steps of 1, 2 or 5 times a power
/// of ten between them; at most 11. If no such step divides the bar, there are five labels.
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
