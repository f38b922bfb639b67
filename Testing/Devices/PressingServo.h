// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_PressingServo_h
#define palpate_testing_PressingServo_h

#include "Contact/ContactBody.h"
#include "Transports/Hid/HidDevice.h"
#include "Haptics/Servo/ServoStep.h"

#include <Eigen/Core>

#include <chrono>
#include <cstdint>
#include <memory>

namespace palpate::testing
{
/// Path of a press on the middle of a plate of 10 mm: five times a second between 0.1 mm above the
/// plate and a depth of 0.5 mm. The path begins at the depth of 0.5 mm.
constexpr double PressPeriod = 0.2; ///< s
/// Number of ticks to wait for an event: at least a minute, which is enough on any machine for an
/// event that takes a second.
constexpr int PatientTicks = 60000;
Eigen::Vector3d press(double seconds);

/// The host's loop at 1 kHz in the caller's thread, with the whole chain from sample to force.
class PressingServo
{
public:
  PressingServo(HidDevice& device, std::shared_ptr<const ContactBody> plate);

  /// Runs one tick, at least 1 ms after the previous tick. Returns true if the loss of the device
  /// had been reported before the tick began.
  bool tick();
  /// Runs ticks until the plate exerts a force, at most PatientTicks. Returns true if it did.
  bool ticksUntilForce();
  void forgetLosses() { this->Losses = this->Device.errors().disconnections; }

  const Eigen::Vector3d& force() const { return this->Force; } ///< force sent in the last tick, N
  /// Time from the last new reading to the last tick, s.
  double silence() const { return this->Silence; }

private:
  HidDevice& Device;
  ServoStep Step;
  std::chrono::steady_clock::time_point Begin = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point Deadline = Begin;
  std::uint64_t Losses = 0;
  double LastReading = 0.0;
  double Silence = 0.0;
  Eigen::Vector3d Force = Eigen::Vector3d::Zero();
};
} // namespace palpate::testing

#endif
