// SPDX-License-Identifier: BSD-3-Clause
#include "CacheFlush.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <new>

#include <sys/mman.h>

namespace palpate::benchmarks
{
namespace
{
/// Returns the size of the last-level cache of the first processor, as reported by the kernel; 0 if
/// it is not reported. (sysconf counts the caches of a whole package.)
std::size_t lastLevelBytes()
{
  std::ifstream file("/sys/devices/system/cpu/cpu0/cache/index3/size");
  std::size_t kibibytes = 0;
  file >> kibibytes;
  return kibibytes << 10;
}
} // namespace

CacheFlush::CacheFlush()
{
  constexpr std::size_t Least = 32U << 20;
  constexpr std::size_t Most = 512U << 20;
  this->Bytes = 3 * std::clamp(lastLevelBytes(), Least, Most);
  void* const memory =
    mmap(nullptr, this->Bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED)
  {
    throw std::bad_alloc();
  }
#ifdef MADV_NOHUGEPAGE
  madvise(memory, this->Bytes, MADV_NOHUGEPAGE);
#endif
  this->Buffer = static_cast<unsigned char*>(memory);
  // Writes, so that each page has its own memory instead of the shared page of zeros
  std::memset(this->Buffer, 1, this->Bytes);
}

CacheFlush::~CacheFlush()
{
  munmap(this->Buffer, this->Bytes);
}

void CacheFlush::operator()() noexcept
{
  constexpr std::size_t Line = 64;
  for (std::size_t i = 0; i < this->Bytes; i += Line)
  {
    static_cast<void>(*const_cast<volatile unsigned char*>(this->Buffer + i));
  }
}
} // namespace palpate::benchmarks
