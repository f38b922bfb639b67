// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Constants_h
#define palpate_Constants_h

#include <limits>

namespace palpate
{
/// π; infinity, used for "no bound"; NaN, used for "unknown".
inline constexpr double Pi = 3.14159265358979323846;
inline constexpr double Infinity = std::numeric_limits<double>::infinity();
inline constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
/// Half the width of a 95 % interval of a normal distribution, in standard deviations.
inline constexpr double Normal95 = 1.959963984540054;
} // namespace palpate

#endif
