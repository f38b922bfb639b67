// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * How many threads the loops of the kernels take: for building bodies, finite elements, reduction.
 * The tick takes none. No result depends on it.
 *
 * One per core, or PALPATE_THREADS of the environment, which is read once; within a ThreadLimit as
 * many as that says, but no more than PALPATE_THREADS where it is set.
 */
#ifndef palpate_ThreadCount_h
#define palpate_ThreadCount_h

#include "Mechanics/PalpateExport.h"

#include <cstddef>

namespace palpate
{
/// Of loops that the calling thread starts; at least 1.
PALPATE_EXPORT std::size_t threadCount() noexcept;

/// While this lives, loops that the thread that made it starts take `count` threads. The innermost
/// one holds; 0 changes nothing.
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
