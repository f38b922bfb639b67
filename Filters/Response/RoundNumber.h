// SPDX-License-Identifier: BSD-3-Clause
#ifndef RoundNumber_h
#define RoundNumber_h

#include <cmath>

namespace palpate
{
/// Returns the largest number of the form 1, 2 or 5 times a power of ten that is at most `value`.
/// `value` must be > 0.
inline double roundDown(double value)
{
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  const double share = value / decade;
  return decade * (share >= 5.0 ? 5.0 : share >= 2.0 ? 2.0 : 1.0);
}

/// Returns the smallest number of the form 1, 2, 3, 4, 6 or 8 times a power of ten that is at least
/// `value`. `value` must be > 0. These forms are used because a quarter of such a number has few
/// digits, too.
inline double roundUp(double value)
{
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double share : { 1.0, 2.0, 3.0, 4.0, 6.0, 8.0 })
  {
    if (value <= share * decade)
    {
      return share * decade;
    }
  }
  return 10.0 * decade;
}
} // namespace palpate

#endif
