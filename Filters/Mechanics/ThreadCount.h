// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The number of threads for loops outside the servo tick: construction of bodies, finite elements,
 * reduction. The servo tick uses no additional threads. No result depends on the number of threads.
 *
 * The default is one thread per core. The environment variable PALPATE_THREADS sets another number;
 * it is read once. While a ThreadLimit exists, its number applies, but at most PALPATE_THREADS if
 * that variable is set.
 */
#ifndef palpate_ThreadCount_h
#define palpate_ThreadCount_h

#include "Mechanics/PalpateExport.h"

#include <cstddef>

namespace palpate
{
/// Returns the number of threads for loops that the calling thread starts; at least 1.
PALPATE_EXPORT std::size_t threadCount() noexcept;

/// During the lifetime of this object, loops started by the same thread use `count` threads. The
/// innermost limit applies; a limit of 0 has no effect.
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
