// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_CacheFlush_h
#define palpate_benchmarks_CacheFlush_h

#include <cstddef>
#include <cstdint>

namespace palpate::benchmarks
{
/**
 * Drives everything else out of the caches by reading through three times the last level, in 4 KiB
 * pages, so that the translations of addresses are driven out as well: what a renderer does to a
 * servo tick between two milliseconds. (After twice the last level, on the machine the targets were
 * set on, a good part of the former contents was still there.)
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
