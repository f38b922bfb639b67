// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FaultyDevice_h
#define palpate_FaultyDevice_h

#include "Haptics/Simulation/DeviceFaults.h"
#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>

namespace palpate
{
/**
 * Another device, with faults (DeviceFaults): to see what a loop makes of them.
 *
 * Deterministic: what happens depends on the faults, the seed and the times read, with a generator
 * of its own (splitmix64; Steele, Lea and Flood 2014); each reading draws one number per kind of
 * fault, so that the rate of one does not move the others. The device within is read in every tick
 * and so moves on; it is sent zero force in the tick of a disconnection, and after it, until it is
 * written again, keeps that.
 *
 * errors() adds to those of the device within: what was dropped as lost, forces not taken as
 * unsent, and disconnections. What repeats or comes late goes unnoticed, as it does at a device
 * that does not number its reports. With wrong settings nothing is connected, and status() says
 * why.
 *
 * A tick costs O(scheduled faults). read and write are the servo thread's, status and errors for
 * any.
 */
class PALPATE_EXPORT FaultyDevice final : public HapticDevice
{
public:
  FaultyDevice(std::unique_ptr<HapticDevice> device, DeviceFaults faults);

  const DeviceSpecification& specification() const noexcept override;
  DeviceSample read(double time) noexcept override;
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    return this->writeWrench({ force, Eigen::Vector3d::Zero() });
  }
  bool writeWrench(const Wrench& wrench) noexcept override;
  std::string status() const override;
  DeviceErrors errors() const noexcept override;

  HapticDevice& device() noexcept { return *this->Device; }

private:
  /// Whether a fault strikes the reading of this time, and until when it lasts.
  struct Strike
  {
    bool is = false;
    bool begins = false;
    double end = -std::numeric_limits<double>::infinity();
  };

  void strike(double time) noexcept;
  DeviceSample tell(const DeviceSample& reading, double time) noexcept;
  /// Uniform in [0, 1).
  double draw() noexcept;
  bool isStruck(DeviceFault fault) const noexcept
  {
    return this->Strikes[static_cast<std::size_t>(fault)].is;
  }

  std::unique_ptr<HapticDevice> Device;
  DeviceFaults Faults;
  std::string Wrong;
  std::uint64_t Generator;
  std::array<Strike, DeviceFaultCount> Strikes;
  double LastTime = -std::numeric_limits<double>::infinity();
  DeviceSample Last; ///< as told
  DeviceSample Late; ///< on its way
  double LateDue = 0.0;
  bool IsLate = false;

  std::atomic<bool> IsGone{ false };
  std::atomic<std::uint64_t> Lost{ 0 };
  std::atomic<std::uint64_t> Unsent{ 0 };
  std::atomic<std::uint64_t> Disconnections{ 0 };
};
} // namespace palpate

#endif
