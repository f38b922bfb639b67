// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ReferenceTable_h
#define palpate_testing_ReferenceTable_h

#include "Mechanics/Files/CsvReader.h"

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace palpate::testing
{
/**
 * A table of Data/Reference. Its first line names the columns. Throws (so that the test fails) if
 * the file, a column or a number is missing.
 */
class ReferenceTable
{
public:
  explicit ReferenceTable(const std::string& name)
  {
    for (CsvReader csv(std::string(PALPATE_DATA_DIR "/Reference/") + name); csv.next();)
    {
      std::vector<std::string> fields;
      for (std::size_t i = 0; i < csv.size(); ++i)
      {
        fields.emplace_back(csv.text(i));
      }
      if (!this->Columns.empty())
      {
        this->Rows.push_back(std::move(fields));
      }
      for (std::size_t i = 0; this->Rows.empty() && i < fields.size(); ++i)
      {
        this->Columns.emplace(fields[i], i);
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
  std::map<std::string, std::size_t> Columns;
  std::vector<std::vector<std::string>> Rows;
};
} // namespace palpate::testing

#endif
