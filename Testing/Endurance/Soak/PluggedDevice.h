// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_PluggedDevice_h
#define palpate_endurance_PluggedDevice_h

#include "Haptics/Devices/HapticDevice.h"

#include <limits>
#include <memory>
#include <utility>

namespace palpate::endurance
{
/// Passes the inner device on unchanged and keeps its last sample, so that a different reported
/// sample is noticed.
class TrueHand final : public HapticDevice
{
public:
  explicit TrueHand(std::unique_ptr<HapticDevice> device)
    : Device(std::move(device))
  {
  }
  const DeviceSpecification& specification() const noexcept override
  {
    return this->Device->specification();
  }
  DeviceSample read(double time) noexcept override { return this->Last = this->Device->read(time); }
  bool write(const Eigen::Vector3d& force) noexcept override { return this->Device->write(force); }
  bool writeWrench(const Wrench& wrench) noexcept override
  {
    return this->Device->writeWrench(wrench);
  }
  const DeviceSample& last() const noexcept { return this->Last; }

private:
  std::unique_ptr<HapticDevice> Device;
  DeviceSample Last;
};

/// A device that is plugged in for a while.
struct PluggedDevice
{
  std::unique_ptr<HapticDevice> device;
  const TrueHand* hand = nullptr;                          ///< inside `device`
  double absence = 0.0;                                    ///< s without any device before it
  double life = 0.0;                                       ///< s
  double hangAt = std::numeric_limits<double>::infinity(); ///< s after it was plugged in
  double hangFor = 0.0; ///< s by which one reading delays the loop
  std::unique_ptr<PluggedDevice> next;
};

} // namespace palpate::endurance

#endif
