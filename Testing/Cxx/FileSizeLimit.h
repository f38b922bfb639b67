// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_FileSizeLimit_h
#define palpate_testing_FileSizeLimit_h

#include <csignal>
#include <cstddef>

#include <sys/resource.h>

namespace palpate::testing
{
/// While this exists, no file of the process grows beyond the given number of bytes. As on a full
/// disk, a write stores the bytes that fit, and the next one fails (EFBIG).
class FileSizeLimit
{
public:
  explicit FileSizeLimit(std::size_t bytes)
    : Handler(std::signal(SIGXFSZ, SIG_IGN))
  {
    getrlimit(RLIMIT_FSIZE, &this->Before);
    rlimit limit = this->Before;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit()
  {
    setrlimit(RLIMIT_FSIZE, &this->Before);
    std::signal(SIGXFSZ, this->Handler);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
  rlimit Before{};
  void (*Handler)(int);
};

constexpr const char* FileTooLarge = "File too large"; ///< the system's text for the error EFBIG
} // namespace palpate::testing

#endif
