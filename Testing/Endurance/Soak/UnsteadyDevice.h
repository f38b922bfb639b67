// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_UnsteadyDevice_h
#define palpate_endurance_UnsteadyDevice_h

#include "Haptics/Devices/HapticDevice.h"
#include "PluggedDevice.h"
#include "Haptics/Servo/SampleRing.h"
#include "Haptics/Servo/SceneExchange.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace palpate::endurance
{
/// The sample read and the force written in one tick, recorded at the device.
struct DeviceRecord
{
  double time = 0.0;
  DeviceSample sample;
  Eigen::Vector3d sent = Eigen::Vector3d::Zero();
};

/// Number of disturbances of each kind.
struct DeviceTroubles
{
  std::uint64_t unplugs = 0;
  std::uint64_t absent = 0;     ///< readings without a valid sample
  std::uint64_t notANumber = 0; ///< readings of NaN that are reported as valid
  std::uint64_t dropped = 0;    ///< readings that are not new: lost or stalled
  std::uint64_t late = 0;       ///< old readings that are reported as new
  std::uint64_t hangs = 0;      ///< readings that delayed the loop
};

/**
 * A device that is repeatedly plugged in and unplugged. Each offered device is plugged in for its
 * life, after a time without a device. Every reading and force is recorded. Devices are handed over
 * and back by two pointers, so that a tick neither allocates nor frees memory.
 * Only the servo thread calls read and write. One other thread calls all other functions.
 */
class UnsteadyDevice final : public HapticDevice
{
public:
  /// `capacity`: number of ticks that are stored until they are drained.
  UnsteadyDevice(const DeviceSpecification& specification, std::size_t capacity);

  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  DeviceSample read(double time) noexcept override;
  bool write(const Eigen::Vector3d& force) noexcept override;

  /// Returns true if the last offered device has been taken.
  bool wantsDevice() const { return this->Wants.load(); }
  /// Offers the next device. Frees the devices that are no longer in use.
  void offer(std::unique_ptr<PluggedDevice> device);

  template <class Sink>
  std::size_t drain(Sink&& sink)
  {
    return this->Records.drain(sink);
  }
  std::uint64_t overruns() const { return this->Records.overruns(); }
  DeviceTroubles troubles() const;
  /// The force that was left on the device. Must be called after the loop has ended.
  const Eigen::Vector3d& lastForce() const { return this->LastForce; }

private:
  void plug(double time) noexcept;
  void count(const DeviceSample& told) noexcept;
  void hang(double time) noexcept;

  DeviceSpecification Limits;
  SampleRing<DeviceRecord> Records;
  SceneExchange<PluggedDevice> Devices;
  std::atomic<bool> Wants{ true };

  std::unique_ptr<PluggedDevice> Current; ///< used only by the servo thread, like the members below
  std::unique_ptr<PluggedDevice> Next;
  /// Time when Current was plugged in, or when the previous device was unplugged, s.
  double Since = 0.0;
  DeviceRecord Open;
  bool IsOpen = false;
  Eigen::Vector3d LastForce = Eigen::Vector3d::Zero();

  std::atomic<std::uint64_t> Unplugs{ 0 };
  std::atomic<std::uint64_t> Absent{ 0 };
  std::atomic<std::uint64_t> NotANumber{ 0 };
  std::atomic<std::uint64_t> Dropped{ 0 };
  std::atomic<std::uint64_t> Late{ 0 };
  std::atomic<std::uint64_t> Hangs{ 0 };
};
} // namespace palpate::endurance

#endif
