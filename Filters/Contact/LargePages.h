// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LargePages_h
#define palpate_LargePages_h

#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Memory that asks for 2 MiB pages: a tick that lands anywhere in some hundred megabytes then
/// misses the cache, but not the translation of addresses too. What takes less than a page shares
/// one with others, of this body or of another; such a page goes back to the system when nobody is
/// left in it. Less than 4 KiB is ordinary memory. Aligned to 64 bytes; from any thread.
class PALPATE_EXPORT LargePageMemory
{
public:
  static constexpr std::size_t PageSize = std::size_t{ 1 } << 21;

  /// Throws std::bad_alloc.
  static void* take(std::size_t bytes);
  /// With as many bytes as were taken.
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

/// Asks for a cache line ahead of its use; any address will do. The empty statement keeps g++ from
/// taking a function that does nothing else for one without effect, whose calls it leaves out.
inline void prefetchLine(const void* memory) noexcept
{
  __builtin_prefetch(memory);
  asm volatile("");
}
} // namespace palpate

#endif
