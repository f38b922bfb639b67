// SPDX-License-Identifier: BSD-3-Clause
#include "NumberRange.h"

#include <charconv>
#include <cmath>
#include <sstream>

namespace palpate
{
namespace
{
/// Shortens a long text for use in a message.
std::string shorten(const std::string& text)
{
  constexpr std::size_t most = 40;
  return text.size() > most ? text.substr(0, most) + "..." : text;
}

std::string demandOf(const NumberRange& range, double value)
{
  std::ostringstream demand;
  if (range.least == -NumberRange::Endless)
  {
    demand << "is not finite";
  }
  else if (!range.includesLeast && value > range.most)
  {
    demand << "is larger than " << range.most;
  }
  else if (!range.includesLeast || range.most == NumberRange::Endless)
  {
    demand << (range.includesLeast ? "is negative" : "is not positive");
  }
  else
  {
    demand << "does not lie between " << range.least << " and " << range.most;
  }
  return demand.str();
}
} // namespace

std::string NumberRange::read(const std::string& text, double& number) const
{
  // The sign is skipped, because from_chars rejects "+".
  const std::size_t sign = !text.empty() && text[0] == '+' ? 1 : 0;
  const char* const end = text.data() + text.size();
  double value = 0.0;
  const auto result = std::from_chars(text.data() + sign, end, value);
  const bool isNumber = result.ptr == end && result.ec != std::errc::invalid_argument;
  std::string fault;
  if (!isNumber)
  {
    fault = "'" + shorten(text) + "' is not a number";
  }
  else if (result.ec == std::errc::result_out_of_range)
  {
    fault = shorten(text) + " is beyond the range of a number";
  }
  else if (!std::isfinite(value))
  {
    fault = shorten(text) + " is not finite";
  }
  else if (value < this->least || value > this->most ||
    (value == this->least && !this->includesLeast))
  {
    fault = shorten(text) + " " + demandOf(*this, value);
  }
  else
  {
    number = value;
    return {};
  }
  return fault + "; " + this->what;
}
} // namespace palpate
