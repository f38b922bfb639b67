// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceWriter_h
#define palpate_ForceWriter_h

#include "Haptics/Servo/BoundedThread.h"
#include "Haptics/Devices/HapticDevice.h"
#include "Haptics/Hid/HidBus.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>

namespace palpate
{
/**
 * Sends forces to a HID device from a thread of its own, so that a slow device delays nobody.
 *
 * send and holdFor, from the tick: send leaves the force and returns at once: no lock, no
 * allocation, no wait. Only the newest force is sent; one that was overtaken while the device took
 * its time is counted as unsent. The other functions belong to other threads. Destroying it sends
 * "no force, amplifiers off", and waits at most a second, even if the driver hangs: the device's
 * own watchdog is there for that.
 */
class PALPATE_EXPORT ForceWriter
{
public:
  /// Each force report asks the device to go to zero when none has followed for `watchdog` µs, or
  /// what holdFor says since.
  explicit ForceWriter(std::uint32_t watchdog);
  ~ForceWriter();
  ForceWriter(const ForceWriter&) = delete;
  ForceWriter& operator=(const ForceWriter&) = delete;

  /// Amplifiers off, for good; also when destroyed.
  void stop();

  /// Where to send from now on; null: nowhere.
  void use(std::shared_ptr<HidPort> port);

  /// N, finite; `stateSequence` is that of the newest state the force rests on. False if the device
  /// did not take the last one.
  bool send(const Eigen::Vector3d& force, std::uint32_t stateSequence) noexcept
  {
    return this->send(Wrench{ force, Eigen::Vector3d::Zero() }, stateSequence);
  }
  bool send(const Wrench& wrench, std::uint32_t stateSequence) noexcept;

  /// Of the forces sent from now on, by the thread that sends them.
  void holdFor(std::uint32_t watchdog) noexcept;

  /// Whether the last force was taken; true before the first.
  bool taken() const noexcept;
  std::uint64_t unsent() const noexcept;

private:
  struct Shared;
  std::shared_ptr<Shared> Work;
  BoundedThread Thread;
};
} // namespace palpate

#endif
