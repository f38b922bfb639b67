// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ParallelRanges_h
#define palpate_ParallelRanges_h

#include "Mechanics/ThreadCount.h"

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace palpate
{
/// The number of ranges of forRanges() for `count` items: one per thread, unless they would be
/// small.
inline std::size_t rangeCount(std::size_t count)
{
  constexpr std::size_t smallest = 8192; // smaller ranges cost more than a thread saves
  return std::max<std::size_t>(1, std::min(threadCount(), count / smallest));
}

/// Calls body(first, last) for contiguous ranges that cover 0..count, each on its own thread. For
/// building, not for the servo tick. `body` must not throw, and must not write where another range
/// writes.
template <class Body>
void forRanges(std::size_t count, const Body& body)
{
  const std::size_t ranges = rangeCount(count);
  const auto run = [&](std::size_t k) { body(k * count / ranges, (k + 1) * count / ranges); };
  std::vector<std::thread> others;
  for (std::size_t k = 1; k < ranges; ++k)
  {
    others.emplace_back(run, k);
  }
  run(0);
  for (std::thread& other : others)
  {
    other.join();
  }
}
} // namespace palpate

#endif
