// SPDX-License-Identifier: BSD-3-Clause
#include "AllocationCount.h"

#include "Sanitized.h"

#include <cstdlib>
#include <new>

#if defined(__GLIBC__) && !defined(PALPATE_SANITIZED)
#define PALPATE_COUNT_MALLOC
#endif

namespace
{
thread_local long Count = 0;

void* allocateOrNull(std::size_t size) noexcept
{
  ++Count;
  return std::malloc(size > 0 ? size : 1);
}

void* allocate(std::size_t size)
{
  void* memory = allocateOrNull(size);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

void* allocateAligned(std::size_t size, std::align_val_t alignment)
{
  ++Count;
  const auto unit = static_cast<std::size_t>(alignment);
  void* memory = std::aligned_alloc(unit, (size + unit - 1) / unit * unit);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

void release(void* memory) noexcept
{
  ++Count;
  std::free(memory);
}
} // namespace

namespace palpate::testing
{
long allocationCount() noexcept
{
  return Count;
}

bool countsMalloc() noexcept
{
#ifdef PALPATE_COUNT_MALLOC
  return true;
#else
  return false;
#endif
}
} // namespace palpate::testing

// The array forms of the standard library call these functions. A sanitizer has its own nothrow
// forms. Memory from these must not be freed by this delete, but std::stable_sort would do so.
void* operator new(std::size_t size)
{
  return allocate(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return allocateOrNull(size);
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
  return allocateAligned(size, alignment);
}
void operator delete(void* memory) noexcept
{
  release(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept
{
  release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
  release(memory);
}

void operator delete(void* memory, const std::nothrow_t&) noexcept
{
  release(memory);
}

#ifdef PALPATE_COUNT_MALLOC
extern "C"
{
  void* __libc_malloc(std::size_t);
  void* __libc_calloc(std::size_t, std::size_t);
  void* __libc_realloc(void*, std::size_t);

  void* malloc(std::size_t size)
  {
    ++Count;
    return __libc_malloc(size);
  }
  void* calloc(std::size_t count, std::size_t size)
  {
    ++Count;
    return __libc_calloc(count, size);
  }
  void* realloc(void* memory, std::size_t size)
  {
    ++Count;
    return __libc_realloc(memory, size);
  }
}
#endif
