// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SharedWork_h
#define palpate_SharedWork_h

#include "Mechanics/ThreadCount.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace palpate
{
/// Receives the completed fraction, 0 to 1. Returns false to stop the work.
using WorkObserver = std::function<bool(double)>;

/**
 * Calls work(i) once for each i < count, on threadCount() threads. Each free thread takes the next
 * index. Intended for items that take long; for short items use forRanges(). The result of an item
 * must not depend on the thread. Each thread has its own copy of `work`, with separate buffers.
 *
 * `observer` may be empty. It is called only by the calling thread, between its items and at the
 * end. Returns false if the observer stopped the work; items that had begun are completed. `work`
 * must not throw.
 */
template <class Work>
bool shareWork(std::size_t count, const Work& work, const WorkObserver& observer = {})
{
  std::atomic<std::size_t> next{ 0 };
  std::atomic<std::size_t> done{ 0 };
  std::atomic<bool> isStopped{ false };
  const auto run = [&](bool reports)
  {
    Work own = work;
    for (std::size_t i = next++; i < count && !isStopped; i = next++)
    {
      own(i);
      const std::size_t finished = ++done;
      if (reports && observer && finished < count &&
        !observer(static_cast<double>(finished) / static_cast<double>(count)))
      {
        isStopped = true;
      }
    }
  };
  std::vector<std::thread> others;
  for (std::size_t t = 1; t < std::min(threadCount(), count); ++t)
  {
    others.emplace_back(run, false);
  }
  run(true);
  for (std::thread& other : others)
  {
    other.join();
  }
  return !isStopped && (!observer || observer(1.0));
}
} // namespace palpate

#endif
