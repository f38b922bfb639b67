// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FileWords_h
#define palpate_FileWords_h

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

namespace palpate
{
/// The words of a text file, line by line. A byte order mark at the start is skipped. Lines end
/// with LF or CR LF.
class FileWords
{
public:
  /// A line that ends with the character `continued` continues on the next line; 0 disables this.
  FileWords(std::istream& stream, char continued = '\0')
    : Stream(stream)
    , Continued(continued)
  {
  }

  /// Moves to the next line; returns false at the end of the file.
  bool nextLine();
  /// Returns the next word of the line, or "" at the end of the line. Valid until the next line is
  /// read.
  std::string_view word();
  /// Reads the next word as a finite number. If the word is not a number, returns false and sets
  /// `wrong` to the word.
  bool number(float& value, std::string_view& wrong);
  /// Number of the current line, from 1.
  std::size_t lineNumber() const { return this->Number; }

  /// Returns the word, or the beginning of a long word, in quotation marks.
  static std::string shown(std::string_view word);

private:
  std::istream& Stream;
  char Continued;
  std::string Line;
  std::size_t Place = 0;
  std::size_t Number = 0;
};
} // namespace palpate

#endif
