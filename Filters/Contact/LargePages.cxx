// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/LargePages.h"

#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <new>
#include <sys/mman.h>

namespace palpate
{
namespace
{
constexpr std::size_t PageSize = LargePageMemory::PageSize;
constexpr std::size_t CacheLine = 64; ///< bytes
constexpr std::size_t SmallestShared = 4096;

/// The first line of a shared page: the number of bytes in use, and the number of blocks.
struct alignas(CacheLine) SharedPage
{
  std::size_t used;
  std::size_t parts;
};

std::mutex Guard;
SharedPage* Open = nullptr; ///< the page from which the next block is allocated

std::size_t roundedUp(std::size_t bytes, std::size_t unit) noexcept
{
  return (bytes + unit - 1) / unit * unit;
}

/// Large pages are disabled with the address sanitizer, because it detects accesses outside a
/// vector only in ordinary memory.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool IsMapped = false;
#elif defined(__has_feature)
constexpr bool IsMapped = !__has_feature(address_sanitizer);
#else
constexpr bool IsMapped = true;
#endif

bool hasOwnPages(std::size_t bytes) noexcept
{
  return IsMapped && bytes > PageSize - sizeof(SharedPage);
}

bool isShared(std::size_t bytes) noexcept
{
  return IsMapped && bytes >= SmallestShared && !hasOwnPages(bytes);
}

void* ordinary(std::size_t bytes)
{
  const std::size_t alignment = bytes >= PageSize ? PageSize : CacheLine;
  void* memory = std::aligned_alloc(alignment, roundedUp(bytes, alignment));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

/// Maps memory directly from the system, because malloc may return memory that is already divided
/// into small pages.
void* ownPages(std::size_t bytes)
{
  const std::size_t size = roundedUp(bytes, PageSize);
  // Large enough to contain an aligned block of `size` bytes.
  const std::size_t asked = size + PageSize;
  void* memory = mmap(nullptr, asked, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED)
  {
    throw std::bad_alloc();
  }
  char* first = static_cast<char*>(memory);
  const auto before = static_cast<std::size_t>(-reinterpret_cast<std::intptr_t>(memory)) % PageSize;
  if (before > 0)
  {
    munmap(first, before);
  }
  munmap(first + before + size, PageSize - before);
  madvise(first + before, size, MADV_HUGEPAGE); // only a hint; without it the memory is slower
  return first + before;
}

void giveBackPages(void* memory, std::size_t bytes) noexcept
{
  munmap(memory, roundedUp(bytes, PageSize));
}

SharedPage* pageOf(void* part) noexcept
{
  char* place = static_cast<char*>(part);
  return reinterpret_cast<SharedPage*>(place - reinterpret_cast<std::uintptr_t>(part) % PageSize);
}
} // namespace

void* LargePageMemory::take(std::size_t bytes)
{
  if (!isShared(bytes))
  {
    return hasOwnPages(bytes) ? ownPages(bytes) : ordinary(bytes);
  }
  const std::size_t size = roundedUp(bytes, CacheLine);
  const std::lock_guard<std::mutex> lock(Guard);
  if (!Open || Open->used + size > PageSize)
  {
    Open = new (ownPages(PageSize)) SharedPage{ sizeof(SharedPage), 0 };
  }
  void* part = reinterpret_cast<char*>(Open) + Open->used;
  Open->used += size;
  ++Open->parts;
  return part;
}

void LargePageMemory::giveBack(void* memory, std::size_t bytes) noexcept
{
  if (!isShared(bytes))
  {
    hasOwnPages(bytes) ? giveBackPages(memory, bytes) : std::free(memory);
    return;
  }
  const std::size_t size = roundedUp(bytes, CacheLine);
  const std::lock_guard<std::mutex> lock(Guard);
  SharedPage* page = pageOf(memory);
  --page->parts;
  if (page->parts == 0)
  {
    Open = page == Open ? nullptr : Open;
    giveBackPages(page, PageSize);
  }
  else if (static_cast<char*>(memory) + size == reinterpret_cast<char*>(page) + page->used)
  {
    page->used -= size; // the block is the newest one, so that its memory can be used again
  }
}
} // namespace palpate
