// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The number of threads for loops of the kernels: building bodies, finite elements,
 * reduction. The servo tick uses none. No result depends on it.
 *
 * One per core, or PALPATE_THREADS of the environment, which is read once; within a ThreadLimit its
 * count, but no more than PALPATE_THREADS if that is set.
 */
#ifndef palpate_ThreadCount_h
#define palpate_ThreadCount_h

#include "Mechanics/PalpateExport.h"

#include <cstddef>

namespace palpate
{
/// For loops that the calling thread starts; at least 1.
PALPATE_EXPORT std::size_t threadCount() noexcept;

/// While this lives, loops started by the same thread use `count` threads. The innermost limit
/// counts; 0 changes nothing.
class PALPATE_EXPORT ThreadLimit
{
public:
  explicit ThreadLimit(std::size_t count) noexcept;
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
  std::size_t Before;
};
} // namespace palpate

#endif
