// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Files/WholeFile.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace palpate
{
namespace
{
namespace fs = std::filesystem;

constexpr mode_t UsualMode = 0666; // permissions before the user's umask is applied

std::string errorText(const std::string& path, int reason)
{
  return "cannot write '" + path + "': " + std::strerror(reason);
}

/// Returns the path of a file with symbolic links resolved. Returns "" if the path exists but is
/// not a file, or if the file no longer has a name.
std::string targetOf(const std::string& path)
{
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  if (!fs::exists(status))
  {
    return path;
  }
  const fs::path target = fs::canonical(path, failed);
  return fs::is_regular_file(status) && !failed ? target.string() : std::string();
}

/// The part of a file up to and including its last line break.
struct WholeLines
{
  std::size_t count = 0;
  off_t size = 0;
};

WholeLines wholeLinesOf(int file)
{
  WholeLines lines;
  std::array<char, 65536> block{};
  off_t begin = 0;
  ssize_t size = 0;
  while ((size = pread(file, block.data(), block.size(), begin)) > 0)
  {
    for (ssize_t i = 0; i < size; ++i)
    {
      if (block[static_cast<std::size_t>(i)] == '\n')
      {
        ++lines.count;
        lines.size = begin + i + 1;
      }
    }
    begin += size;
  }
  return lines;
}
} // namespace

std::string WholeFile::obstacle(const std::string& path)
{
  const std::string target = targetOf(path);
  struct stat status = {};
  const bool exists = stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode))
  {
    return errorText(path, EISDIR);
  }
  std::string folder = fs::path(target).parent_path().string();
  folder = folder.empty() ? "." : folder;
  const bool isOpen = target.empty() ? access(path.c_str(), W_OK) == 0
                                     : access((folder + "/.").c_str(), W_OK | X_OK) == 0;
  return isOpen ? std::string() : errorText(path, errno);
}

WholeFile::WholeFile(std::string path)
  : Path(std::move(path))
  , Target(targetOf(this->Path))
  , Unfinished(this->Target.empty() ? this->Path : this->Target + ".part")
{
}

WholeFile::~WholeFile()
{
  if (this->File >= 0)
  {
    close(this->File);
    if (this->isFile() && !this->Kept)
    {
      std::remove(this->Unfinished.c_str());
    }
  }
}

std::string WholeFile::open()
{
  std::string problem = obstacle(this->Path);
  if (!problem.empty())
  {
    return problem;
  }
  // The user may have permission to write to a terminal or a pipe, but not to read from it.
  const int access = this->isFile() ? O_RDWR | O_CREAT : O_WRONLY;
  this->File = ::open(this->Unfinished.c_str(), access | O_TRUNC | O_CLOEXEC, UsualMode);
  return this->File >= 0 ? std::string() : this->error(errno);
}

void WholeFile::write(const void* bytes, std::size_t size) noexcept
{
  const auto* next = static_cast<const std::uint8_t*>(bytes);
  while (size > 0 && this->Reason == 0)
  {
    const ssize_t count = ::write(this->File, next, size);
    if (count > 0)
    {
      next += count;
      size -= static_cast<std::size_t>(count);
    }
    else if (count == 0 || errno != EINTR)
    {
      this->Reason = count == 0 ? ENOSPC : errno;
    }
  }
}

std::string WholeFile::finish()
{
  if (this->Reason == 0 && this->isFile() &&
    (fsync(this->File) != 0 || std::rename(this->Unfinished.c_str(), this->Target.c_str()) != 0))
  {
    this->Reason = errno;
  }
  if (this->Reason != 0)
  {
    return this->error(this->Reason);
  }
  const int file = std::exchange(this->File, -1);
  return close(file) == 0 ? std::string() : this->error(errno);
}

std::size_t WholeFile::keepLines(std::size_t least)
{
  if (this->File < 0 || !this->isFile())
  {
    return 0;
  }
  const WholeLines lines = wholeLinesOf(this->File);
  this->Kept = lines.count >= least && ftruncate(this->File, lines.size) == 0;
  return this->Kept ? lines.count : 0;
}

std::string WholeFile::error(int reason) const
{
  return errorText(this->Path, reason);
}
} // namespace palpate
