// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CsvReader_h
#define palpate_CsvReader_h

#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <fstream>
#include <functional>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace palpate
{
/**
 * Comma-separated values, record by record (RFC 4180): every table that Palpate reads from a file.
 *
 * Where the first record has a semicolon, semicolons separate the fields, and numbers may have a
 * decimal comma, as spreadsheets write them in many languages; one mark in all numbers of a file.
 * A field in double quotes may hold separators, ends of line, and quotes as ""; blanks around a
 * field are dropped. Ignored are a byte order mark, empty lines, lines that begin with '#' (after
 * `comment` has seen them), and columns that are not asked for. Lines end with LF or CR LF.
 *
 *   CsvReader csv(path);
 *   csv.header({ "time_s", "force_N" }, 2);
 *   while (csv.next())
 *   {
 *     add(csv.number(0), csv.number(1));
 *   }
 *   return csv.fault();
 *
 * The first fault is kept, and ends the reading: "file:line: what is wrong", for a field with the
 * name of its column. Nothing throws but std::bad_alloc.
 */
class PALPATE_EXPORT CsvReader
{
public:
  /// Supplies the fields of the next record; false: there are no more.
  using Records = std::function<bool(std::vector<std::string>& fields)>;

  explicit CsvReader(std::string path);
  /// The stream must outlive this; `name` stands for the file in errors.
  CsvReader(std::istream& stream, std::string name);
  /// A table that has been read already: the names of its columns, then its rows. Errors are
  /// "name: row 7: what is wrong", rows counting from 0.
  CsvReader(Records records, std::string name);
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  /// Called with the text of a comment, without its '#'; returns what is wrong with it, or "".
  std::function<std::string(std::string_view text)> comment;

  /// Goes to the next record; false at the end, or after a fault. Once the columns have names, a
  /// record of another number of fields is a fault.
  bool next();
  /// The next record names the columns.
  bool header(std::vector<std::string_view> names, std::size_t required);
  /// This record names the columns: `names` in any order, of which the first `required` must be
  /// there, and none twice. From then on columns are numbered by their place in `names`; before, by
  /// their place in the record. The texts of the names must outlive the reader.
  bool columns(std::vector<std::string_view> names, std::size_t required);
  /// Whether the columns from `begin` to before `end` exist; if only some do, it is a fault.
  bool hasColumns(std::size_t begin, std::size_t end);
  bool hasColumn(std::size_t column) const { return this->Place[column] != Absent; }

  std::size_t size() const { return this->Fields.size(); }
  /// "" for a missing column.
  std::string_view text(std::size_t column) const;
  /// The number of a field; 0 and a fault unless it is finite.
  double number(std::size_t column);
  /// Whether the last record read ends with a line break; without one it may have been cut short.
  bool endsLine() const { return this->EndsLine; }

  /// Sets a fault of the last record read. Returns false.
  bool fail(const std::string& what);
  /// "": nothing is wrong.
  const std::string& fault() const { return this->Fault; }

private:
  static constexpr std::size_t Absent = static_cast<std::size_t>(-1);

  bool readLine();
  bool readRecord();
  bool split();
  void findSeparator();
  bool readDecimals(std::string_view text, double& value);
  std::string place() const;

  std::ifstream File;
  std::istream* Stream = nullptr; ///< null: a table
  Records Table;
  std::string Name;
  std::string Line;
  char Separator = '\0'; ///< not known yet, or a table
  char DecimalMark = '\0';
  std::size_t LineCount = 0;
  std::size_t Begin = 0; ///< line of the last record read; of a table, number of rows read
  bool EndsLine = true;
  std::vector<std::string> Fields;
  std::size_t FieldCount = 0; ///< of every record; 0: any
  std::vector<std::string_view> Names;
  std::vector<std::size_t> Place; ///< index of each name among the fields
  std::string Fault;
};

/// The text without blanks at its ends.
PALPATE_EXPORT std::string_view trimmed(std::string_view text);

/// The trimmed texts before and after the first colon of a comment, "key: value".
struct PALPATE_EXPORT CsvComment
{
  explicit CsvComment(std::string_view text);
  std::string_view key;
  std::string_view value;
};
} // namespace palpate

#endif
