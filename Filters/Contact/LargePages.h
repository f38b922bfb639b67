// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LargePages_h
#define palpate_LargePages_h

#include <cstddef>
#include <cstdlib>
#include <new>
#include <sys/mman.h>
#include <vector>

namespace palpate
{
/// Memory that asks for 2 MiB pages where it is large enough to hold some: a tick that lands
/// anywhere in some hundred megabytes then misses the cache, but not the translation of addresses
/// too.
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
    const std::size_t bytes = count * sizeof(Value);
    const std::size_t alignment = bytes >= PageSize ? PageSize : SmallAlignment;
    void* memory = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
    if (!memory)
    {
      throw std::bad_alloc();
    }
    if (bytes >= PageSize)
    {
      madvise(memory, bytes, MADV_HUGEPAGE); // a wish; without it the memory is as good, but slower
    }
    return static_cast<Value*>(memory);
  }
  void deallocate(Value* memory, std::size_t) noexcept { std::free(memory); }

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

private:
  static constexpr std::size_t PageSize = std::size_t{ 1 } << 21;
  static constexpr std::size_t SmallAlignment = 64; ///< of a cache line
};

template <class Value>
using LargeVector = std::vector<Value, LargePages<Value>>;
} // namespace palpate

#endif
