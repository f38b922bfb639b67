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
 * Sends forces to a HID device from its own thread, so that a slow device does not delay the tick.
 *
 * send and holdFor are for the tick: send stores the force and returns at once, without lock,
 * allocation or wait. Only the newest force is sent; one replaced while the device was busy counts
 * as unsent. The other functions are for other threads. Destroying it sends "no force, amplifiers
 * off", and waits at most a second, even if the driver hangs, when the device's own watchdog acts.
 */
class PALPATE_EXPORT ForceWriter
{
public:
  /// Each force report asks the device to go to zero if none follows for `watchdog` µs, or for the
  /// time set by holdFor.
  explicit ForceWriter(std::uint32_t watchdog);
  ~ForceWriter();
  ForceWriter(const ForceWriter&) = delete;
  ForceWriter& operator=(const ForceWriter&) = delete;

  /// Amplifiers off, for good; also when destroyed.
  void stop();

  /// The port for sending from now on; null: none.
  void use(std::shared_ptr<HidPort> port);

  /// N, finite; `stateSequence` is that of the newest state the force is based on. False if the
  /// device did not accept the last one.
  bool send(const Eigen::Vector3d& force, std::uint32_t stateSequence) noexcept
  {
    return this->send(Wrench{ force, Eigen::Vector3d::Zero() }, stateSequence);
  }
  bool send(const Wrench& wrench, std::uint32_t stateSequence) noexcept;

  /// Sets the watchdog of the forces sent from now on; for the thread that calls send.
  void holdFor(std::uint32_t watchdog) noexcept;

  /// Whether the last force was accepted; true before the first.
  bool taken() const noexcept;
  std::uint64_t unsent() const noexcept;

private:
  struct Shared;
  std::shared_ptr<Shared> Work;
  BoundedThread Thread;
};
} // namespace palpate

#endif
