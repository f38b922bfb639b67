// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SteeredDevice_h
#define palpate_SteeredDevice_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Devices/SteeredTarget.h"

namespace palpate
{
/**
 * A device without hardware, steered from another thread, as by a mouse: a hand that follows its
 * target with a time constant, whatever it feels.
 *
 * The position is the hand's aim itself (SteeredTarget); a hand that feels is a SimulatedDevice
 * with a plant. steerTo is for one thread, read and write for the servo thread; neither waits.
 */
class PALPATE_EXPORT SteeredDevice final : public HapticDevice
{
public:
  static constexpr double TimeConstant = SteeredTarget::TimeConstant; ///< s

  explicit SteeredDevice(
    const Eigen::Vector3d& start, const DeviceSpecification& specification = {});

  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  DeviceSample read(double time) noexcept override;
  bool write(const Eigen::Vector3d& force) noexcept override;

  /// Where the hand is to go, m.
  void steerTo(const Eigen::Vector3d& target) noexcept { this->Target.steerTo(target); }

private:
  DeviceSpecification Limits;
  SteeredTarget Target;
};
} // namespace palpate

#endif
