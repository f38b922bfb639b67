// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceRelease_h
#define palpate_ForceRelease_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"

#include <atomic>

namespace palpate
{
/**
 * Ends the force on the hand before an exception ends the process. To be called by programs.
 *
 * An exception that is not caught, or that leaves a function which must not throw (such as read and
 * write of a HapticDevice), ends the process by std::terminate, without destructors. The last force
 * would then remain until the device's own watchdog ends it. After this call, std::terminate first
 * makes every running ServoLoop write zero force, and the terminating thread waits up to 0.1 s for
 * that. Then std::terminate proceeds as usual.
 *
 * A library must not call this, because it changes the behaviour of the whole process. Signals,
 * such as SIGSEGV or SIGKILL, are not caught: then only the device's watchdog acts.
 */
PALPATE_EXPORT void releaseForceOnTerminate() noexcept;

/// An object on a servo thread's stack while a device may exert a force: one for each device of the
/// thread, destroyed in reverse order.
class PALPATE_EXPORT ForceHold
{
public:
  explicit ForceHold(HapticDevice& device) noexcept;
  ~ForceHold();
  ForceHold(const ForceHold&) = delete;
  ForceHold& operator=(const ForceHold&) = delete;

  /// Whether the process is terminating: the loop must then write zero force and end.
  static bool mustRelease() noexcept { return Releasing.load(std::memory_order_relaxed); }

private:
  friend void releaseForceOnTerminate() noexcept;
  static void releaseAll() noexcept;

  static std::atomic<bool> Releasing;
  static thread_local ForceHold* Newest; ///< the newest object of this servo thread

  HapticDevice& Device;
  ForceHold* Before;
};
} // namespace palpate

#endif
