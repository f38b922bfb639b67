// SPDX-License-Identifier: BSD-3-Clause
#include "CallClock.h"

#include <algorithm>
#include <vector>

namespace palpate::benchmarks
{
CallClock::CallClock()
{
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const std::uint64_t first = start();
  while (Clock::now() - begin < std::chrono::milliseconds(100))
  {
  }
  const std::chrono::duration<double, std::nano> passed = Clock::now() - begin;
  this->NanosecondsPerCount = passed.count() / static_cast<double>(stop() - first);

  std::vector<std::uint64_t> empty(10001);
  for (std::uint64_t& counts : empty)
  {
    const std::uint64_t from = start();
    counts = stop() - from;
  }
  std::sort(empty.begin(), empty.end());
  this->Overhead = empty[empty.size() / 2];
  const auto above = std::upper_bound(empty.begin(), empty.end(), empty.front());
  this->Step = above == empty.end() ? 1 : *above - empty.front();
}
} // namespace palpate::benchmarks
