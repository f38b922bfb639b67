// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LargePages_h
#define palpate_LargePages_h

#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Memory in 2 MiB pages, if possible. A servo tick reads at random in a few hundred megabytes.
/// With large pages it misses the cache, but not the translation lookaside buffer (TLB). Smaller
/// blocks share a page, also blocks of different bodies; such a page is freed with its last block.
/// Blocks of less than 4 KiB are in ordinary memory. Blocks are aligned to 64 bytes. Thread-safe.
class PALPATE_EXPORT LargePageMemory
{
public:
  static constexpr std::size_t PageSize = std::size_t{ 1 } << 21;

  /// Allocates memory; throws std::bad_alloc on failure.
  static void* take(std::size_t bytes);
  /// Frees memory returned by take(). `bytes` must be the value given to take().
  static void giveBack(void* memory, std::size_t bytes) noexcept;
};

/// Allocator for containers of the standard library that uses LargePageMemory.
template <class Value>
class LargePages
{
public:
  using value_type = Value;

  LargePages() = default;
  template <class Other>
  explicit LargePages(const LargePages<Other>&) noexcept
  {
  }

  Value* allocate(std::size_t count)
  {
    return static_cast<Value*>(LargePageMemory::take(count * sizeof(Value)));
  }
  void deallocate(Value* memory, std::size_t count) noexcept
  {
    LargePageMemory::giveBack(memory, count * sizeof(Value));
  }

  template <class Other>
  bool operator==(const LargePages<Other>&) const noexcept
  {
    return true;
  }
  template <class Other>
  bool operator!=(const LargePages<Other>&) const noexcept
  {
    return false;
  }
};

template <class Value>
using LargeVector = std::vector<Value, LargePages<Value>>;

/// Prefetches a cache line. Any address is allowed. The empty asm statement is needed because g++
/// omits calls of a function that only prefetches, as one without effect.
inline void prefetchLine(const void* memory) noexcept
{
  __builtin_prefetch(memory);
  asm volatile("");
}
} // namespace palpate

#endif
