// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Prefetch_h
#define palpate_Prefetch_h

namespace palpate
{
/// Asks for a cache line ahead of its use; any address will do. The empty statement keeps g++ from
/// taking a function that does nothing else for one without effect, whose calls it leaves out.
inline void prefetchLine(const void* memory) noexcept
{
  __builtin_prefetch(memory);
  asm volatile("");
}
} // namespace palpate

#endif
