// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_CacheFlush_h
#define palpate_benchmarks_CacheFlush_h

#include <cstddef>
#include <cstdint>

namespace palpate::benchmarks
{
/**
 * Evicts all other data from the caches. It reads three times the size of the last level, in pages
 * of 4 KiB, so that address translations are evicted as well. A renderer has this effect between
 * two ticks at 1 kHz. (After a read of twice the last level, much of the former contents was still
 * in the cache on the machine on which the targets were set.)
 */
class CacheFlush
{
public:
  CacheFlush();
  ~CacheFlush();
  CacheFlush(const CacheFlush&) = delete;
  CacheFlush& operator=(const CacheFlush&) = delete;

  void operator()() noexcept;
  std::size_t bytes() const noexcept { return this->Bytes; }

private:
  std::size_t Bytes;
  unsigned char* Buffer = nullptr;
};
} // namespace palpate::benchmarks

#endif
