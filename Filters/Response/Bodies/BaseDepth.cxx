// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/BaseDepth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
double findBaseDepth(const double* grey, std::size_t count, const BaseCriteria& criteria)
{
  const auto isDark = [&criteria](double value) { return value < criteria.baseValue; };
  const double* end =
    std::find_if(grey, grey + count, [](double value) { return !std::isfinite(value); });
  const double* tissue = std::find_if_not(grey, end, isDark);
  while (tissue != end)
  {
    const double* dark = std::find_if(tissue, end, isDark);
    const double* beyond = std::find_if_not(dark, end, isDark);
    const std::ptrdiff_t above = std::min(dark - tissue, criteria.edge);
    const std::ptrdiff_t below = std::min(beyond - dark, criteria.edge);
    if (beyond - dark >= std::max<std::ptrdiff_t>(criteria.darkCount, 1))
    {
      const double high = *std::max_element(dark - above, dark);
      const double* lowest = std::min_element(dark, dark + below);
      if (*lowest <= 0.5 * high)
      {
        const double middle = 0.5 * (high + *lowest);
        const double* last = lowest - 1; // last sample above the mean
        while (*last < middle)
        {
          --last;
        }
        return static_cast<double>(last - grey) + (last[0] - middle) / (last[0] - last[1]);
      }
    }
    tissue = beyond;
  }
  return std::numeric_limits<double>::infinity();
}
} // namespace palpate
