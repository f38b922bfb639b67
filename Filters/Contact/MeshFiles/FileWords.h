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
  /// `continued`: a character at the end of a line that continues the line on the next one; 0:
  /// none.
  FileWords(std::istream& stream, char continued = '\0')
    : Stream(stream)
    , Continued(continued)
  {
  }

  /// Moves to the next line; returns false at the end of the file.
  bool nextLine();
  /// Returns the next word of the line; "" at its end. Valid until the next line.
  std::string_view word();
  /// Reads the next word as a finite number. If the word is not a number, returns false and sets
  /// `wrong` to the word.
  bool number(float& value, std::string_view& wrong);
  /// Number of the line, from 1.
  std::size_t lineNumber() const { return this->Number; }

  /// The word, or the beginning of a long word, in quotes.
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
