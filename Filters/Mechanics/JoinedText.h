// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_JoinedText_h
#define palpate_JoinedText_h

#include <sstream>
#include <string>

namespace palpate
{
/// Joins the parts into one text. Each part is formatted as by operator<< of a stream.
template <class... Parts>
std::string joined(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}
} // namespace palpate

#endif
