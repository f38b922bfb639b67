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
/// On the middle of a plate of 10 mm: five times a second from 0.1 mm above it to 0.5 mm deep,
/// where it begins.
constexpr double PressPeriod = 0.2; ///< s
/// Ticks in which what is awaited comes on any machine: a minute at least, for what takes a second.
constexpr int PatientTicks = 60000;
Eigen::Vector3d press(double seconds);

/// The host's loop at 1 kHz, in the caller's own thread, with everything between sample and force.
class PressingServo
{
public:
  PressingServo(HidDevice& device, std::shared_ptr<const ContactBody> plate);

  /// One tick, 1 ms or more after the one before. Whether the loss of the device had been reported
  /// when it began.
  bool tick();
  /// Ticks until the plate is felt, PatientTicks at most. Whether it was.
  bool ticksUntilForce();
  void forgetLosses() { this->Losses = this->Device.errors().disconnections; }

  const Eigen::Vector3d& force() const { return this->Force; } ///< sent in the last tick, N
  /// s at the last tick since one with a new reading.
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
