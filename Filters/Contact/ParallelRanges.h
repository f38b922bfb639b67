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
/// Returns the number of ranges into which forRanges() divides `count` items: one per thread, or
/// fewer if the ranges would be small.
inline std::size_t rangeCount(std::size_t count)
{
  // For smaller ranges, starting a thread costs more time than it saves.
  constexpr std::size_t smallest = 8192;
  return std::max<std::size_t>(1, std::min(threadCount(), count / smallest));
}

/// Calls body(first, last) for contiguous ranges that cover 0..count, each on its own thread. Used
/// to build bodies, not in the servo tick. `body` must not throw, and must not write to memory that
/// is used for another range.
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
