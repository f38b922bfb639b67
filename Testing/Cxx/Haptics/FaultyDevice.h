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
 * A device that adds faults (DeviceFaults) to another device, to test the reaction of a loop.
 *
 * Deterministic: the events depend only on the faults, the seed and the times of the readings. It
 * has its own random generator (splitmix64; Steele, Lea and Flood 2014). Each reading draws one
 * number per kind of fault, so that the rate of one fault does not influence the others. The inner
 * device is read in every tick, so its motion continues. The inner device gets zero force in the
 * tick of a disconnection, and this force is held until the next write.
 * and keeps this force until the next write.
 * errors() adds to the errors of the inner device: dropped samples as lost, refused forces as
 * unsent, and disconnections. Repeated or late samples are not counted, as for a device that does
 * not number its reports. With wrong settings no device is connected, and status() gives the
 * reason.
 * reason.
 *
 * A tick costs O(scheduled faults). read and write are for the servo thread, status and errors for
 * any thread.
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
  /// Whether a fault occurs at the reading of this time, and its end.
  struct Strike
  {
    bool is = false;
    bool begins = false;
    double end = -std::numeric_limits<double>::infinity();
  };

  void strike(double time) noexcept;
  DeviceSample tell(const DeviceSample& reading, double time) noexcept;
  /// Random number, uniform in [0, 1).
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
  DeviceSample Last; ///< the last sample returned
  DeviceSample Late; ///< a delayed sample
  double LateDue = 0.0;
  bool IsLate = false;

  std::atomic<bool> IsGone{ false };
  std::atomic<std::uint64_t> Lost{ 0 };
  std::atomic<std::uint64_t> Unsent{ 0 };
  std::atomic<std::uint64_t> Disconnections{ 0 };
};
} // namespace palpate

#endif
