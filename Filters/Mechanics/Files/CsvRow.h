// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CsvRow_h
#define palpate_CsvRow_h

#include "Mechanics/Files/NumberText.h"

#include <string>
#include <string_view>

namespace palpate
{
/// Writes one record of comma-separated values. CsvReader reads the numbers back bit for bit. Texts
/// are quoted if necessary.
class CsvRow
{
public:
  template <class Number>
  CsvRow& number(Number value)
  {
    return this->put(shortestDecimals(value));
  }
  CsvRow& text(std::string_view text)
  {
    if (text.find_first_of(",\"\r\n#") == std::string_view::npos)
    {
      return this->put(text);
    }
    std::string quoted = "\"";
    for (const char character : text)
    {
      quoted.append(character == '"' ? 2 : 1, character);
    }
    return this->put(quoted + '"');
  }
  /// Returns the record with its line break.
  std::string line() const { return this->Fields + '\n'; }

private:
  CsvRow& put(std::string_view field)
  {
    this->Fields += this->IsBegun ? "," : "";
    this->Fields += field;
    this->IsBegun = true;
    return *this;
  }

  std::string Fields;
  bool IsBegun = false;
};
} // namespace palpate

#endif
