// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceRelease_h
#define palpate_ForceRelease_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"

#include <atomic>

namespace palpate
{
/**
 * For programs: lets one that dies of an exception let go of the hand first.
 *
 * An exception that nobody catches, or that leaves a function which must not throw (such as read
 * and write of a HapticDevice), ends the process by std::terminate, without destructors: the last
 * force would stay until the device's own watchdog ends it. After this call every running ServoLoop
 * first writes zero force, for which the dying thread waits up to 0.1 s; then std::terminate does
 * what it did before.
 *
 * A library does not call this, because it changes what the whole process does. Signals, such as
 * SIGSEGV or SIGKILL, are not caught: what is left then is the device's watchdog.
 */
PALPATE_EXPORT void releaseForceOnTerminate() noexcept;

/// What a servo thread has on its stack for as long as its device may exert a force: one for each
/// of its devices, of which the last made ends first.
class PALPATE_EXPORT ForceHold
{
public:
  explicit ForceHold(HapticDevice& device) noexcept;
  ~ForceHold();
  ForceHold(const ForceHold&) = delete;
  ForceHold& operator=(const ForceHold&) = delete;

  /// The process is about to die: write zero force and come to an end.
  static bool mustRelease() noexcept { return Releasing.load(std::memory_order_relaxed); }

private:
  friend void releaseForceOnTerminate() noexcept;
  static void releaseAll() noexcept;

  static std::atomic<bool> Releasing;
  static thread_local ForceHold* Newest; ///< of this servo thread

  HapticDevice& Device;
  ForceHold* Before;
};
} // namespace palpate

#endif
