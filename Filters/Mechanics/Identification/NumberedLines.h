// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_NumberedLines_h
#define palpate_NumberedLines_h

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

/// Text files read line by line, with errors that name file and line.
namespace palpate::NumberedLines
{
/// Without the blanks at its ends.
inline std::string_view trim(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos)
  {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// "name:line: fault".
inline std::string locate(const std::string& name, std::size_t line, const std::string& fault)
{
  std::string text = name;
  text += ":";
  text += std::to_string(line);
  text += ": ";
  text += fault;
  return text;
}

/// Gives every line, trimmed, to `reader.line(std::string_view)`, and then calls `reader.end()`:
/// both return what is wrong, or "". A byte order mark is passed over. Returns the first fault,
/// located, or "".
template <class Reader>
std::string read(std::istream& stream, const std::string& name, Reader& reader)
{
  std::string text;
  std::size_t number = 0;
  while (std::getline(stream, text))
  {
    ++number;
    std::string_view line = text;
    if (number == 1 && line.substr(0, 3) == "\xEF\xBB\xBF")
    {
      line.remove_prefix(3);
    }
    const std::string fault = reader.line(trim(line));
    if (!fault.empty())
    {
      return locate(name, number, fault);
    }
  }
  if (stream.bad())
  {
    return name + ": cannot be read to its end";
  }
  const std::string fault = reader.end();
  return fault.empty() ? std::string() : locate(name, number, fault);
}
} // namespace palpate::NumberedLines

#endif
