// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_PluggedDevice_h
#define palpate_endurance_PluggedDevice_h

#include "Haptics/Devices/HapticDevice.h"

#include <limits>
#include <memory>
#include <utility>

namespace palpate::endurance
{
/// Passes on all calls to the inner device unchanged and stores its last sample. A different sample
/// in a report is therefore detected.
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

/// A device that is plugged in for a limited time.
struct PluggedDevice
{
  std::unique_ptr<HapticDevice> device;
  const TrueHand* hand = nullptr; ///< the part of `device` that stores the true sample
  double absence = 0.0;           ///< time without any device before this device, s
  double life = 0.0;              ///< time for which the device is plugged in, s
  /// Time of the hang since the device was plugged in, s.
  double hangAt = std::numeric_limits<double>::infinity();
  double hangFor = 0.0; ///< delay of the loop by one reading, s
  std::unique_ptr<PluggedDevice> next;
};

} // namespace palpate::endurance

#endif
