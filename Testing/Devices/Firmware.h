// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_Firmware_h
#define palpate_testing_Firmware_h

#include "EmulatedHid.h"

#include "palpate_hid.h"

#include <Eigen/Core>

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace palpate::testing
{
/// Position (m) at a time since the start (s).
using HandPath = std::function<Eigen::Vector3d(double)>;

/// A force device as its maker would describe it: 6 N, 2500 N/m, a time-out of 20 ms.
palpate_hid_description describedDevice();
HidModel modelOf(const palpate_hid_description& description);

/**
 * The firmware of a force device: palpate_hid.c in a loop of 1 kHz on an emulated HID device, in a
 * thread of its own, with the hand's path for sensors and nothing for motors.
 */
class Firmware
{
public:
  Firmware(EmulatedHid& hid, HandPath hand);
  /// The loop ends; the device stays plugged in.
  ~Firmware();

  /// A firmware that hangs: it neither reads nor writes, from the return of this call on.
  void hang(bool yes);

  /// Copies, of this moment.
  palpate_hid state() const;
  Eigen::Vector3d motors() const; ///< N
  /// Whether the motors have had this force (N) at any time. The watchdog takes it away after
  /// 20 ms, in which a thread on a busy machine may not have looked.
  bool hasApplied(const Eigen::Vector3d& force) const;
  std::uint64_t forcesTaken() const;
  /// States that the host's side had no room for, because it did not read.
  std::uint64_t statesNotSent() const;
  /// For each force taken, how many states had been sent since the one it rests on.
  std::vector<std::uint32_t> delays() const;

private:
  void run();
  void tick(std::uint64_t now);

  EmulatedHid& Hid;
  HandPath Hand;
  mutable std::mutex Mutex;
  palpate_hid State{};
  Eigen::Vector3d Motors = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> Applied; ///< each force that differs from the one before
  std::uint64_t Taken = 0;
  std::uint64_t NotSent = 0;
  std::vector<std::uint32_t> Delays;
  bool Hanging = false; ///< under Mutex
  std::atomic<bool> Stopping{ false };
  std::thread Thread;
};
} // namespace palpate::testing

#endif
