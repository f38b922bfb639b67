// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RealTimeGrant_h
#define palpate_RealTimeGrant_h

#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
/// What a servo thread asks the system for.
struct RealTimeRequest
{
  /// SCHED_FIFO with this priority, 1 to 99; 0: stay with the scheduling there is.
  int priority = 80;
  /**
   * Keep the memory of the whole process from being paged out, whatever it touches now or later
   * (mlockall with MCL_ONFAULT: nothing is read in for it, and memory that is never touched costs
   * nothing). Off, because it is the process's own business: a program with gigabytes, of which a
   * servo loop is a small part, may want to page. It stays in force after the loop. Programs that
   * are there for the loop should ask for it.
   */
  bool lockMemory = false;
};

/**
 * What the system granted, and why not more.
 *
 * Refusals are no errors: without SCHED_FIFO a loop ticks as well, with later wake-ups when the
 * processors are busy. Root is granted all of it, others what their limits say (RLIMIT_RTPRIO; in
 * Debian `/etc/security/limits.conf`: rtprio, memlock).
 */
struct PALPATE_EXPORT RealTimeGrant
{
  RealTimeRequest request;
  /// Of SCHED_FIFO; 0: the scheduling is what it was. Less than requested where the limit is lower.
  int priority = 0;
  int priorityError = 0; ///< errno of what was refused first; 0: nothing was
  bool memoryLocked = false;
  int memoryError = 0;     ///< errno
  bool timerSlack = false; ///< 1 ns instead of 50 µs for a thread that is not SCHED_FIFO

  /// One line: "SCHED_FIFO 80 granted; memory not locked: not asked for; timer slack 1 ns".
  std::string describe() const;
};

/**
 * Asks for the calling thread, and touches the first 64 KiB of its stack, so that no tick has to
 * wait for a page of it. Memory is locked only where no limit stands against it: mlockall under a
 * limit would make allocations of the process fail later.
 */
PALPATE_EXPORT RealTimeGrant requestRealTime(const RealTimeRequest& request) noexcept;
} // namespace palpate

#endif
