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
 * Reads comma-separated values, one record at a time (RFC 4180). Palpate reads all its table files
 * with this class.
 *
 * If the first record has a semicolon, semicolons separate the fields. Numbers may then have a
 * decimal comma, as spreadsheets write them in many languages. All numbers of a file must use the
 * same decimal mark. A field in double quotes may contain separators, line breaks, and quotes,
 * which are written as "". Blanks around a field are removed. The reader ignores a byte order mark,
 * empty lines, columns that the caller did not name, and lines that begin with '#'. These comment
 * lines are passed to `comment`. Lines end with LF or CR LF.
 *
 *   CsvReader csv(path);
 *   csv.header({ "time_s", "force_N" }, 2);
 *   while (csv.next())
 *   {
 *     add(csv.number(0), csv.number(1));
 *   }
 *   return csv.fault();
 *
 * After the first fault the reader stops, and the fault is kept. It has the form "file:line:
 * reason"; the fault of a field also names its column. The only exception thrown is std::bad_alloc.
 */
class PALPATE_EXPORT CsvReader
{
public:
  /// Supplies the fields of the next record. Returns false if there are no more records.
  using Records = std::function<bool(std::vector<std::string>& fields)>;

  explicit CsvReader(std::string path);
  /// `name` replaces the file name in error messages. The stream must outlive the reader.
  CsvReader(std::istream& stream, std::string name);
  /// Reads a table that is already in memory: first the names of its columns, then its rows. Error
  /// messages have the form "name: row 7: reason"; rows count from 0.
  CsvReader(Records records, std::string name);
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  /// Called with the text of a comment line without its '#'. Returns a fault, or "".
  std::function<std::string(std::string_view text)> comment;

  /// Moves to the next record. Returns false at the end or after a fault. Once the columns have
  /// names, a record with a different number of fields is a fault.
  bool next();
  /// Reads the next record and uses it as the names of the columns, see columns().
  bool header(std::vector<std::string_view> names, std::size_t required);
  /// Uses the current record as the names of the columns. The names may be in any order. The first
  /// `required` of `names` must be present, and no name may occur twice. After this call, columns
  /// are addressed by their index in `names`; before it, by their index in the record. The texts of
  /// `names` must outlive the reader.
  bool columns(std::vector<std::string_view> names, std::size_t required);
  /// Returns whether the columns `begin` <= i < `end` exist. It is a fault if only some of these
  /// columns exist.
  bool hasColumns(std::size_t begin, std::size_t end);
  bool hasColumn(std::size_t column) const { return this->Place[column] != Absent; }

  std::size_t size() const { return this->Fields.size(); }
  /// Returns the text of a field; "" for a missing column.
  std::string_view text(std::size_t column) const;
  /// Returns the number in a field. If it is not a finite number, returns 0 and sets a fault.
  double number(std::size_t column);
  /// Whether the last record ends with a line break. If not, the file may have been truncated.
  bool endsLine() const { return this->EndsLine; }

  /// Sets a fault for the last record. Returns false.
  bool fail(const std::string& what);
  /// The first fault; "" if there was none.
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
  std::istream* Stream = nullptr; ///< null if a table is read
  Records Table;
  std::string Name;
  std::string Line;
  char Separator = '\0'; ///< '\0' if it is not yet known, or if a table is read
  char DecimalMark = '\0';
  std::size_t LineCount = 0;
  std::size_t Begin = 0; ///< line of the last record; for a table, the number of rows read
  bool EndsLine = true;
  std::vector<std::string> Fields;
  std::size_t FieldCount = 0; ///< number of fields of every record; 0 if it is not fixed
  std::vector<std::string_view> Names;
  std::vector<std::size_t> Place; ///< index of each name among the fields of a record
  std::string Fault;
};

/// Returns the text without blanks at its ends.
PALPATE_EXPORT std::string_view trimmed(std::string_view text);

/// The trimmed texts before and after the first colon of a comment "key: value".
struct PALPATE_EXPORT CsvComment
{
  explicit CsvComment(std::string_view text);
  std::string_view key;
  std::string_view value;
};
} // namespace palpate

#endif
