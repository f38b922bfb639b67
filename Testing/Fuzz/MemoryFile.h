// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_MemoryFile_h
#define palpate_testing_MemoryFile_h

#include "Require.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <string>

namespace palpate::testing
{
/// A file in memory whose content changes from run to run.
class MemoryFile
{
public:
  MemoryFile()
    : File(memfd_create("fuzz", MFD_CLOEXEC))
  {
    require(this->File >= 0, "there is room for a file");
  }
  ~MemoryFile() { close(this->File); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  void hold(const void* bytes, std::size_t size)
  {
    require(ftruncate(this->File, 0) == 0 &&
        pwrite(this->File, bytes, size, 0) == static_cast<ssize_t>(size),
      "the file takes its content");
  }
  std::string path() const { return "/proc/self/fd/" + std::to_string(this->File); }

private:
  int File;
};
} // namespace palpate::testing

#endif
