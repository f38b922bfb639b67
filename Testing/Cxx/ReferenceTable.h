// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ReferenceTable_h
#define palpate_testing_ReferenceTable_h

#include <cstddef>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace palpate::testing
{
/**
 * A table of Data/Reference: comma separated, one head line, fields with commas in double quotes.
 * Throws (so that the test fails) when the file, a column or a number is missing.
 */
class ReferenceTable
{
public:
  explicit ReferenceTable(const std::string& name)
  {
    std::ifstream file(std::string(PALPATE_DATA_DIR "/Reference/") + name);
    std::string line;
    while (std::getline(file, line))
    {
      if (this->Columns.empty())
      {
        for (const std::string& column : split(line))
        {
          this->Columns.emplace(column, this->Columns.size());
        }
      }
      else if (!line.empty())
      {
        this->Rows.push_back(split(line));
      }
    }
    if (this->Rows.empty())
    {
      throw std::runtime_error("no table " + name);
    }
  }

  std::size_t size() const { return this->Rows.size(); }
  const std::string& text(std::size_t row, const std::string& column) const
  {
    return this->Rows.at(row).at(this->Columns.at(column));
  }
  double number(std::size_t row, const std::string& column) const
  {
    return std::stod(this->text(row, column));
  }

private:
  static std::vector<std::string> split(const std::string& line)
  {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (const char c : line)
    {
      if (c == '"')
      {
        quoted = !quoted;
      }
      else if (c == ',' && !quoted)
      {
        fields.emplace_back();
      }
      else if (c != '\r')
      {
        fields.back() += c;
      }
    }
    return fields;
  }

  std::map<std::string, std::size_t> Columns;
  std::vector<std::vector<std::string>> Rows;
};
} // namespace palpate::testing

#endif
