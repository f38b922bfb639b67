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
/// Position (m) as a function of the time since the start (s).
using HandPath = std::function<Eigen::Vector3d(double)>;

/// Returns the description of a force device as its manufacturer would write it: 6 N, 2500 N/m, a
/// time-out of 20 ms.
palpate_hid_description describedDevice();
HidModel modelOf(const palpate_hid_description& description);

/**
 * The firmware of a force device: palpate_hid.c in a loop of 1 kHz on an emulated HID device, in
 * its own thread. The path of the hand replaces the sensors; there are no motors.
 */
class Firmware
{
public:
  Firmware(EmulatedHid& hid, HandPath hand);
  /// Stops the loop. The device stays plugged in.
  ~Firmware();

  /// With `yes`, the firmware hangs: after the return of this call it neither reads nor writes.
  void hang(bool yes);

  /// Returns a copy of the present state.
  palpate_hid state() const;
  Eigen::Vector3d motors() const; ///< N
  /// Returns true if the motors have had this force (N) at any time. The present force is not
  /// sufficient for this check: the watchdog removes a force after 20 ms, and on a busy machine a
  /// thread may not run within that time.
  bool hasApplied(const Eigen::Vector3d& force) const;
  std::uint64_t forcesTaken() const;
  /// Number of states that could not be sent, because the host did not read.
  std::uint64_t statesNotSent() const;
  /// For each received force: the number of states sent since the state to which the force
  /// responds.
  std::vector<std::uint32_t> delays() const;

private:
  void run();
  void tick(std::uint64_t now);

  EmulatedHid& Hid;
  HandPath Hand;
  mutable std::mutex Mutex;
  palpate_hid State{};
  Eigen::Vector3d Motors = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> Applied; ///< each force that differs from the previous one
  std::uint64_t Taken = 0;
  std::uint64_t NotSent = 0;
  std::vector<std::uint32_t> Delays;
  bool Hanging = false; ///< protected by Mutex
  std::atomic<bool> Stopping{ false };
  std::thread Thread;
};
} // namespace palpate::testing

#endif
