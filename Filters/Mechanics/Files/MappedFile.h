// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MappedFile_h
#define palpate_MappedFile_h

#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// A file that is mapped into memory for reading. Pages are loaded on access and shared with other
/// processes that map the file. If the file is truncated while it is mapped, a read beyond its end
/// aborts the program (SIGBUS). Therefore files must be replaced with WholeFile.
class PALPATE_EXPORT MappedFile
{
public:
  MappedFile() = default;
  ~MappedFile() { this->close(); }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  /// Opens and maps a file. Returns "" on success, else "cannot open 'PATH': " or "cannot map
  /// 'PATH': " with the system's reason. An empty file, a folder or a pipe results in size 0.
  std::string open(const std::string& path);
  void close() noexcept;

  /// The first byte of the file, aligned to a page; null if there are no bytes.
  const unsigned char* bytes() const noexcept { return static_cast<unsigned char*>(this->Bytes); }
  std::size_t size() const noexcept { return this->Size; }

private:
  void* Bytes = nullptr;
  std::size_t Size = 0;
};
} // namespace palpate

#endif
