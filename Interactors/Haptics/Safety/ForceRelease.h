// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceRelease_h
#define palpate_ForceRelease_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"

#include <atomic>

namespace palpate
{
/**
 * Ends the force on the hand before an exception ends the process. This function is for programs,
 * not for libraries, because it changes the behaviour of the whole process.
 *
 * An exception that is not caught, or that leaves a function which must not throw (such as read and
 * write of a HapticDevice), ends the process by std::terminate, without destructors. The last force
 * would then remain until the device's own watchdog ends it. After this call, std::terminate first
 * makes every running ServoLoop write zero force. The terminating thread waits up to 0.1 s for
 * these writes. Then std::terminate proceeds as usual.
 *
 * Signals such as SIGSEGV or SIGKILL are not caught. After a signal, only the device's watchdog
 * ends the force.
 */
PALPATE_EXPORT void releaseForceOnTerminate() noexcept;

/// An object that exists on the stack of a servo thread while a device may exert a force. The
/// thread has one object for each device and destroys them in reverse order.
class PALPATE_EXPORT ForceHold
{
public:
  explicit ForceHold(HapticDevice& device) noexcept;
  ~ForceHold();
  ForceHold(const ForceHold&) = delete;
  ForceHold& operator=(const ForceHold&) = delete;

  /// Whether the process is terminating. The loop must then write zero force and end.
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
