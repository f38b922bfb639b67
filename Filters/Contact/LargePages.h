// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LargePages_h
#define palpate_LargePages_h

#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Memory in 2 MiB pages, if possible. A servo tick that reads anywhere in some hundred megabytes
/// then misses the cache, but not the address translation. Smaller parts share a page, also between
/// bodies; such a page is freed with its last part. Less than 4 KiB is ordinary memory. Aligned to
/// 64 bytes; thread-safe.
class PALPATE_EXPORT LargePageMemory
{
public:
  static constexpr std::size_t PageSize = std::size_t{ 1 } << 21;

  /// Throws std::bad_alloc.
  static void* take(std::size_t bytes);
  /// `bytes` as in take().
  static void giveBack(void* memory, std::size_t bytes) noexcept;
};

/// The same for containers.
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

/// Prefetches a cache line; any address is allowed. Without the empty asm statement g++ treats a
/// function that only prefetches as one without effect and omits its calls.
inline void prefetchLine(const void* memory) noexcept
{
  __builtin_prefetch(memory);
  asm volatile("");
}
} // namespace palpate

#endif
