// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Files/MappedFile.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace palpate
{
std::string MappedFile::open(const std::string& path)
{
  this->close();
  const auto failed = [&path](const char* what)
  { return std::string("cannot ") + what + " '" + path + "': " + std::strerror(errno); };
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0)
  {
    return failed("open");
  }
  std::string error;
  struct stat status = {};
  if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0)
  {
    const auto size = static_cast<std::size_t>(status.st_size);
    void* const bytes = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (bytes == MAP_FAILED)
    {
      error = failed("map");
    }
    else
    {
      this->Bytes = bytes;
      this->Size = size;
    }
  }
  ::close(file);
  return error;
}

void MappedFile::close() noexcept
{
  if (this->Bytes)
  {
    munmap(this->Bytes, this->Size);
  }
  this->Bytes = nullptr;
  this->Size = 0;
}
} // namespace palpate
