// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Constants_h
#define palpate_Constants_h

#include <limits>

namespace palpate
{
/// The circle constant, and what stands for "no bound" and "not known".
inline constexpr double Pi = 3.14159265358979323846;
inline constexpr double Infinity = std::numeric_limits<double>::infinity();
inline constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
/// Standard deviations within which 95 % of what is distributed normally lies.
inline constexpr double Normal95 = 1.959963984540054;
} // namespace palpate

#endif
