// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_NumberText_h
#define palpate_NumberText_h

#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace palpate
{
/// Reads the whole text as one finite number. Returns false if it is not a finite number; `value`
/// is then undefined.
template <class Number>
bool readNumber(std::string_view text, Number& value)
{
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  const bool isWhole = read.ec == std::errc() && read.ptr == end;
  if constexpr (std::is_floating_point_v<Number>)
  {
    return isWhole && std::isfinite(value);
  }
  return isWhole;
}

/// Returns the shortest decimal text from which the same bits are read back.
template <class Number>
std::string shortestDecimals(Number value)
{
  char buffer[40];
  return { buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr };
}

/// Returns a number with three significant digits, for messages.
inline std::string shortly(double value)
{
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", value);
  return buffer;
}

/// Returns a fraction as a percentage with two digits, for example "1.3 %"; from 99.5 % without
/// decimals.
inline std::string inPercent(double fraction)
{
  char buffer[32];
  const bool isSmall = fraction < 0.995;
  const double percent = isSmall ? 100.0 * fraction : std::round(100.0 * fraction);
  std::snprintf(buffer, sizeof buffer, "%.*g %%", isSmall ? 2 : 9, percent);
  return buffer;
}
} // namespace palpate

#endif
