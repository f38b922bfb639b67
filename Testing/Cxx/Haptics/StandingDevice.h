// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_StandingDevice_h
#define palpate_testing_StandingDevice_h

#include "Haptics/Devices/HapticDevice.h"
#include "Haptics/Servo/ServoLoop.h"

#include <algorithm>
#include <cstdint>
#include <thread>

namespace palpate::testing
{
/// A device that stands still and stores the forces. The test reads them after the loop has
/// stopped. onRead is called in every tick and can be overridden for further actions.
class StandingDevice : public HapticDevice
{
public:
  explicit StandingDevice(const Eigen::Vector3d& where)
    : Position(where)
  {
  }
  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  DeviceSample read(double time) noexcept override
  {
    this->Increasing = this->Increasing && time > this->Time;
    this->Time = time;
    DeviceSample sample;
    sample.position = this->Position;
    sample.valid = true;
    this->onRead(sample, this->Reads++);
    return sample;
  }
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    this->Strongest = std::max(this->Strongest, force.norm());
    this->Last = force;
    return true;
  }

  DeviceSpecification Limits;
  Eigen::Vector3d Position;
  Eigen::Vector3d Last = Eigen::Vector3d::Zero();
  double Strongest = 0.0;
  double Time = -1.0;
  bool Increasing = true;
  std::uint64_t Reads = 0;

protected:
  virtual void onRead(DeviceSample&, std::uint64_t) {}
};

/// Waits until the loop has made `count` ticks. The time limit of the test bounds the wait.
inline void waitForTicks(const ServoLoop& loop, std::uint64_t count)
{
  while (loop.ticks() < count)
  {
    std::this_thread::yield();
  }
}
} // namespace palpate::testing

#endif
