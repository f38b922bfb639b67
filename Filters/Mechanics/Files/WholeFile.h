// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_WholeFile_h
#define palpate_WholeFile_h

#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace palpate
{
/**
 * A file that is written as a whole: under another name beside it, PATH.part, which takes the place
 * of an old file when all of it is on the disk. Until then, and after any failure, the old one
 * stands as it was. A link is followed, and what is no file (a terminal, a pipe, /dev/null) is
 * written to directly.
 *
 * Errors are "cannot write 'PATH': ", then the system's reason.
 */
class PALPATE_EXPORT WholeFile
{
public:
  /// Why no such file can be begun: its folder is missing or may not be written to, or it is a
  /// folder itself; "" if nothing is in the way. Touches nothing.
  static std::string obstacle(const std::string& path);

  explicit WholeFile(std::string path);
  /// Removes what was not finished, unless it was to be kept.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Returns an error, or "".
  std::string open();
  /// After a failure does nothing: finish() tells.
  void write(const void* bytes, std::size_t size) noexcept;
  void write(std::string_view text) noexcept { this->write(text.data(), text.size()); }
  /// Everything to the disk, then its name. Returns an error, or "".
  std::string finish();
  /// After an error of finish: keeps the unfinished file up to its last whole line, if there are
  /// at least so many. How many there are; 0: nothing is kept.
  std::size_t keepLines(std::size_t least);

  /// Where it is written until it is finished, for writers that open a file by its name.
  const std::string& unfinished() const { return this->Unfinished; }
  /// Whether PATH is or will be a file, and not written to directly.
  bool isFile() const { return this->Unfinished != this->Path; }

private:
  std::string error(int reason) const;

  std::string Path;       ///< as it was given
  std::string Target;     ///< where its links lead
  std::string Unfinished; ///< equal to Path: written to directly
  int File = -1;
  int Reason = 0; ///< errno of the first failure
  bool Kept = false;
};
} // namespace palpate

#endif
