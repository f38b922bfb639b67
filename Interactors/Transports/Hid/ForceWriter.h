// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceWriter_h
#define palpate_ForceWriter_h

#include "Haptics/Servo/BoundedThread.h"
#include "Haptics/Devices/HapticDevice.h"
#include "Transports/Hid/HidBus.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>

namespace palpate
{
/**
 * Sends forces to a HID device from a separate thread, so that a slow device does not delay the
 * tick.
 *
 * send and holdFor are for the servo tick. send stores the force and returns immediately, without
 * lock, allocation or wait. Only the newest force is sent; a force that is replaced while the
 * device is busy counts as unsent. The other functions are for other threads. The destructor sends
 * "no force, amplifiers off" and waits at most one second. If the driver hangs, the device's own
 * watchdog ends the force.
 */
class PALPATE_EXPORT ForceWriter
{
public:
  /// Each force report asks the device to set zero force if no further report follows within
  /// `watchdog` µs, or within the time set by holdFor.
  explicit ForceWriter(std::uint32_t watchdog);
  ~ForceWriter();
  ForceWriter(const ForceWriter&) = delete;
  ForceWriter& operator=(const ForceWriter&) = delete;

  /// Switches the amplifiers off permanently. The destructor does the same.
  void stop();

  /// Sets the port to which the following forces are sent. If `port` is null, no force is sent.
  void use(std::shared_ptr<HidPort> port);

  /// Sends a force. `force` is in N and must be finite. `stateSequence` is the number of the newest
  /// state, on which the force is based. Returns false if the device did not accept the last force.
  bool send(const Eigen::Vector3d& force, std::uint32_t stateSequence) noexcept
  {
    return this->send(Wrench{ force, Eigen::Vector3d::Zero() }, stateSequence);
  }
  bool send(const Wrench& wrench, std::uint32_t stateSequence) noexcept;

  /// Sets the watchdog (µs) of the following forces. For the thread that calls send.
  void holdFor(std::uint32_t watchdog) noexcept;

  /// Whether the device accepted the last force. True before the first force.
  bool taken() const noexcept;
  std::uint64_t unsent() const noexcept;

private:
  struct Shared;
  std::shared_ptr<Shared> Work;
  BoundedThread Thread;
};
} // namespace palpate

#endif
