// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RealTimeGrant_h
#define palpate_RealTimeGrant_h

#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
/// Requests of a servo thread to the system.
struct RealTimeRequest
{
  /// Priority of SCHED_FIFO, 1 to 99; 0: keeps the present scheduling.
  int priority = 80;
  /**
   * Whether to lock the memory of the whole process, present and future, so that it is not paged
   * out (mlockall with MCL_ONFAULT: nothing is read in because of the lock, and memory that is
   * never used costs nothing). Off by default, because it affects the whole process: a program with
   * gigabytes, of which a servo loop is a small part, may need paging. The lock remains after the
   * end of the loop. Programs whose main task is the loop should set this option.
   */
  bool lockMemory = false;
};

/**
 * The rights that the system granted, and the reasons of refusals.
 *
 * A refusal is not an error: without SCHED_FIFO a loop works in the same way, but wakes up later
 * when the processors are busy. All requests of root are granted, those of other users as far as
 * their limits allow (RLIMIT_RTPRIO; in Debian `/etc/security/limits.conf`: rtprio, memlock).
 */
struct PALPATE_EXPORT RealTimeGrant
{
  RealTimeRequest request;
  /// Granted priority of SCHED_FIFO; 0: the scheduling is unchanged. Less than the requested
  /// priority if the limit is lower.
  int priority = 0;
  int priorityError = 0; ///< errno of the first refusal; 0: none
  bool memoryLocked = false;
  int memoryError = 0;     ///< errno
  bool timerSlack = false; ///< 1 ns instead of 50 µs for a thread that is not SCHED_FIFO

  /// One line: "SCHED_FIFO 80 granted; memory not locked: not asked for; timer slack 1 ns".
  std::string describe() const;
};

/**
 * Makes the requests for the calling thread. Also writes to the first 64 KiB of its stack, so that
 * no tick waits for a page of the stack. Memory is locked only if locked memory is not limited:
 * with a limit, mlockall would make later allocations of the process fail.
 */
PALPATE_EXPORT RealTimeGrant requestRealTime(const RealTimeRequest& request) noexcept;
} // namespace palpate

#endif
