// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RealTimeGrant_h
#define palpate_RealTimeGrant_h

#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
/// The requests of a servo thread to the operating system.
struct RealTimeRequest
{
  /// Priority of SCHED_FIFO, 1 to 99. With 0 the present scheduling is kept.
  int priority = 80;
  /**
   * Whether to lock the present and future memory of the whole process, so that it is not paged
   * out. mlockall is called with MCL_ONFAULT: the lock loads no pages, and memory that is never
   * used costs nothing. The lock remains after the end of the loop. Off by default, because the
   * lock affects the whole process: a program that uses gigabytes may need paging. Programs whose
   * main task is the loop should set this option.
   */
  bool lockMemory = false;
};

/**
 * The rights that the system granted, and the reasons of refusals.
 *
 * A refusal is not an error. Without SCHED_FIFO a loop works in the same way, but wakes up later
 * when the processors are busy. All requests of root are granted. Requests of other users are
 * granted within the limits of the user (RLIMIT_RTPRIO; in Debian rtprio and memlock in
 * `/etc/security/limits.conf`).
 */
struct PALPATE_EXPORT RealTimeGrant
{
  RealTimeRequest request;
  /// Granted priority of SCHED_FIFO. It is less than the requested priority if the limit is lower.
  /// It is 0 if the scheduling is unchanged.
  int priority = 0;
  int priorityError = 0; ///< errno of the first refusal; 0 if there was none
  bool memoryLocked = false;
  int memoryError = 0; ///< errno of the refusal to lock the memory; 0 if there was none
  /// Whether the timer slack is 1 ns; for a thread without SCHED_FIFO it would be 50 µs.
  bool timerSlack = false;

  /// Describes the grant in one line: "SCHED_FIFO 80 granted; memory not locked: not requested;
  /// timer slack 1 ns".
  std::string describe() const;
};

/**
 * Requests the rights for the calling thread. Also writes to the first 64 KiB of the stack of this
 * thread, so that no tick waits for a page of the stack. Memory is locked only if the process has
 * no limit on locked memory, because with a limit mlockall would make later allocations fail.
 */
PALPATE_EXPORT RealTimeGrant requestRealTime(const RealTimeRequest& request) noexcept;
} // namespace palpate

#endif
