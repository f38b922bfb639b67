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
 * A file that is written completely or not at all. The data are written to PATH.part in the same
 * folder. This file replaces an existing file once all data are on the disk. Until then, and after
 * any failure, the existing file is unchanged. Symbolic links are followed. A terminal, a pipe or
 * /dev/null is written to directly.
 *
 * Error messages have the form "cannot write 'PATH': " with the system's reason.
 */
class PALPATE_EXPORT WholeFile
{
public:
  /// Returns the reason why a file cannot be written: its folder is missing or not writable, or the
  /// path is a folder. Returns "" if the file can be written. Does not change anything.
  static std::string obstacle(const std::string& path);

  explicit WholeFile(std::string path);
  /// Removes an unfinished file, unless keepLines() has kept it.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Opens the file. Returns an error message, or "" on success.
  std::string open();
  /// Appends bytes. After a failure, which finish() reports, this function does nothing.
  void write(const void* bytes, std::size_t size) noexcept;
  void write(std::string_view text) noexcept { this->write(text.data(), text.size()); }
  /// Writes all data to the disk, then renames the file. Returns an error message, or "" on
  /// success.
  std::string finish();
  /// To be called after an error of finish(). Keeps the unfinished file up to its last complete
  /// line if it has at least `least` lines. Returns the number of lines kept; 0 if the file was not
  /// kept.
  std::size_t keepLines(std::size_t least);

  /// The path of the unfinished file, for writers that open a file by its name.
  const std::string& unfinished() const { return this->Unfinished; }
  /// Returns whether PATH is or will be a regular file. Other files are written to directly.
  bool isFile() const { return this->Unfinished != this->Path; }

private:
  std::string error(int reason) const;

  std::string Path;       ///< the path as given by the caller
  std::string Target;     ///< the path with links resolved
  std::string Unfinished; ///< equal to Path if the target is written to directly
  int File = -1;
  int Reason = 0; ///< errno of the first failure
  bool Kept = false;
};
} // namespace palpate

#endif
