// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Files/CsvReader.h"

#include "Mechanics/Files/NumberText.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
std::string quoted(std::string_view text)
{
  return "'" + std::string(text) + "'";
}

/// Returns the text of a comment without the separators that a spreadsheet appends for empty
/// fields.
std::string_view withoutSeparators(std::string_view text)
{
  const std::size_t last = text.find_last_not_of(" \t\r;,");
  return trimmed(text.substr(0, last == std::string_view::npos ? 0 : last + 1));
}
} // namespace

std::string_view trimmed(std::string_view text)
{
  const char* const blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos
    ? std::string_view()
    : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

CsvComment::CsvComment(std::string_view text)
  : key(trimmed(text.substr(0, text.find(':'))))
  , value(trimmed(text.substr(std::min(text.find(':'), text.size() - 1) + 1)))
{
}

CsvReader::CsvReader(std::string path)
  : File(path, std::ios::binary)
  , Stream(&this->File)
  , Name(std::move(path))
{
  if (!this->File)
  {
    this->Fault = this->Name + ": cannot be opened";
  }
}

CsvReader::CsvReader(std::istream& stream, std::string name)
  : Stream(&stream)
  , Name(std::move(name))
{
}

CsvReader::CsvReader(Records records, std::string name)
  : Table(std::move(records))
  , Name(std::move(name))
{
}

bool CsvReader::next()
{
  if (!this->Fault.empty() || !(this->Stream ? this->readRecord() : this->Table(this->Fields)))
  {
    return false;
  }
  if (!this->Stream)
  {
    ++this->Begin;
  }
  return this->FieldCount == 0 || this->size() == this->FieldCount ||
    this->fail("has " + std::to_string(this->size()) + " fields instead of " +
      std::to_string(this->FieldCount));
}

bool CsvReader::header(std::vector<std::string_view> names, std::size_t required)
{
  return this->next() ? this->columns(std::move(names), required)
                      : this->fail("there is no line with the names of the columns");
}

bool CsvReader::columns(std::vector<std::string_view> names, std::size_t required)
{
  this->Names = std::move(names);
  this->Place.assign(this->Names.size(), Absent);
  this->FieldCount = this->size();
  // Rows of a table are counted from the row after the column names.
  this->Begin = this->Stream ? this->Begin : 0;
  for (std::size_t i = 0; i < this->Names.size(); ++i)
  {
    const auto found = std::find(this->Fields.begin(), this->Fields.end(), this->Names[i]);
    if (found != this->Fields.end())
    {
      this->Place[i] = static_cast<std::size_t>(found - this->Fields.begin());
      if (std::find(found + 1, this->Fields.end(), this->Names[i]) != this->Fields.end())
      {
        return this->fail("column " + quoted(this->Names[i]) + " occurs twice");
      }
    }
  }
  for (std::size_t i = 0; i < required; ++i)
  {
    if (!this->hasColumn(i))
    {
      return this->fail("column " + quoted(this->Names[i]) + " is missing");
    }
  }
  return this->Fault.empty();
}

bool CsvReader::hasColumns(std::size_t begin, std::size_t end)
{
  bool hasAny = false;
  std::size_t missing = Absent;
  for (std::size_t i = begin; i < end; ++i)
  {
    hasAny = hasAny || this->hasColumn(i);
    missing = missing == Absent && !this->hasColumn(i) ? i : missing;
  }
  return hasAny &&
    (missing == Absent || this->fail("column " + quoted(this->Names[missing]) + " is missing"));
}

std::string_view CsvReader::text(std::size_t column) const
{
  const std::size_t place = this->Names.empty() ? column : this->Place[column];
  return place < this->size() ? std::string_view(this->Fields[place]) : std::string_view();
}

double CsvReader::number(std::size_t column)
{
  const std::string_view text = this->text(column);
  double value = 0.0;
  if (!this->readDecimals(text, value))
  {
    this->fail((this->Names.empty() ? "column " + std::to_string(column + 1)
                                    : std::string(this->Names[column])) +
      ": " + quoted(text) + " is not a finite number");
    return 0.0;
  }
  return value;
}

/// Reads a number with a decimal point. A decimal comma is also read if commas do not separate the
/// fields.
bool CsvReader::readDecimals(std::string_view text, double& value)
{
  const std::size_t mark = text.find_first_of(this->Separator == ',' ? "." : ".,");
  if (mark == std::string_view::npos)
  {
    return readNumber(text, value);
  }
  if (this->DecimalMark != '\0' && this->DecimalMark != text[mark])
  {
    return this->fail(quoted(text) + " has another decimal mark than the numbers before");
  }
  this->DecimalMark = text[mark];
  if (this->DecimalMark == '.')
  {
    return readNumber(text, value);
  }
  std::string pointed(text);
  pointed[mark] = '.';
  return readNumber(std::string_view(pointed), value);
}

bool CsvReader::fail(const std::string& what)
{
  if (this->Fault.empty())
  {
    this->Fault = this->place() + ": " + what;
  }
  return false;
}

std::string CsvReader::place() const
{
  if (this->Stream)
  {
    return this->Name + ":" + std::to_string(this->Begin);
  }
  return this->Names.empty() || this->Begin == 0
    ? this->Name
    : this->Name + ": row " + std::to_string(this->Begin - 1);
}

bool CsvReader::readLine()
{
  if (!std::getline(*this->Stream, this->Line))
  {
    return false;
  }
  this->EndsLine = !this->Stream->eof();
  if (!this->Line.empty() && this->Line.back() == '\r')
  {
    this->Line.pop_back();
  }
  if (++this->LineCount == 1 && this->Line.compare(0, 3, "\xEF\xBB\xBF") == 0)
  {
    this->Line.erase(0, 3);
  }
  return true;
}

bool CsvReader::readRecord()
{
  while (this->readLine())
  {
    this->Begin = this->LineCount;
    const std::string_view line = trimmed(this->Line);
    if (!line.empty() && line.front() != '#')
    {
      return this->split();
    }
    const std::string wrong = line.empty() || !this->comment
      ? std::string()
      : this->comment(withoutSeparators(line.substr(1)));
    if (!wrong.empty())
    {
      return this->fail(wrong);
    }
  }
  if (this->Stream->bad())
  {
    this->Fault = this->Name + ": cannot be read to its end";
  }
  return false;
}

/// Finds the separator in the first record.
void CsvReader::findSeparator()
{
  bool isQuoted = false;
  this->Separator = ',';
  for (const char c : this->Line)
  {
    isQuoted = isQuoted != (c == '"');
    this->Separator = c == ';' && !isQuoted ? ';' : this->Separator;
  }
}

bool CsvReader::split()
{
  if (this->Separator == '\0')
  {
    this->findSeparator();
  }
  const auto skipBlanks = [this](std::size_t at)
  { return std::min(this->Line.find_first_not_of(" \t\r", at), this->Line.size()); };
  std::size_t count = 0;
  for (std::size_t at = 0;; ++at)
  {
    if (count == this->Fields.size())
    {
      this->Fields.emplace_back();
    }
    // The memory of the field is reused for the next record.
    std::string& field = this->Fields[count++];
    field.clear();
    at = skipBlanks(at);
    if (at < this->Line.size() && this->Line[at] == '"')
    {
      for (++at;; ++at)
      {
        while (at >= this->Line.size())
        {
          if (!this->readLine())
          {
            return this->fail("a quote is not closed");
          }
          field += '\n';
          at = 0;
        }
        if (this->Line[at] == '"' && this->Line.compare(at + 1, 1, "\"") != 0)
        {
          break;
        }
        at += this->Line[at] == '"' ? 1 : 0;
        field += this->Line[at];
      }
      field = trimmed(field);
      at = skipBlanks(at + 1);
      if (at < this->Line.size() && this->Line[at] != this->Separator)
      {
        return this->fail("field " + std::to_string(count) + " continues after its closing quote");
      }
    }
    else
    {
      const std::size_t end = std::min(this->Line.find(this->Separator, at), this->Line.size());
      field = trimmed(std::string_view(this->Line).substr(at, end - at));
      at = end;
    }
    if (at == this->Line.size())
    {
      this->Fields.resize(count);
      return true;
    }
  }
}
} // namespace palpate
