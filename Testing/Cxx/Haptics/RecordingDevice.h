// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RecordingDevice_h
#define palpate_RecordingDevice_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Servo/SampleRing.h"
#include "Haptics/Devices/Trajectory.h"
#include "Haptics/Devices/WorkspaceMapping.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// What went through a device in one tick; its own frame, SI units.
struct RecordedSample
{
  double time = 0.0;
  DeviceSample sample;
  Eigen::Vector3d force = Eigen::Vector3d::Zero(); ///< written; zero if none was
  bool isTaken = false;                            ///< by the device: the force
};

/**
 * Records another device: every reading with its time and the force written upon it, in a
 * preallocated ring (SampleRing). Readings and forces pass unchanged.
 *
 * A recording belongs to the device: its frame, no contact, no mapping. It goes to a file by
 * trajectoryOf, and from there to a ReplayDevice that reads the same bits.
 *
 * read and write are the servo thread's; drain may run in one other at the same time. Drained often
 * enough it records without end; otherwise the newest readings are lost and counted (overruns). A
 * reading is kept when its force is written or the next one is read: the last one before the loop
 * ends counts once it was answered. Forces beyond the first of a reading, as the zero that a loop
 * sends when it stops, are passed on but not kept.
 */
class PALPATE_EXPORT RecordingDevice final : public HapticDevice
{
public:
  /// `capacity`: readings kept until they are drained; 150 bytes each.
  RecordingDevice(std::unique_ptr<HapticDevice> device, std::size_t capacity);

  const DeviceSpecification& specification() const noexcept override;
  DeviceSample read(double time) noexcept override;
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    return this->writeWrench({ force, Eigen::Vector3d::Zero() });
  }
  bool writeWrench(const Wrench& wrench) noexcept override;
  std::string status() const override { return this->Device->status(); }
  DeviceErrors errors() const noexcept override { return this->Device->errors(); }

  /// Appends what was recorded since the last call.
  void drain(std::vector<RecordedSample>& samples);
  /// Readings that found no room.
  std::uint64_t overruns() const noexcept { return this->Ring.overruns(); }
  HapticDevice& device() noexcept { return *this->Device; }

private:
  std::unique_ptr<HapticDevice> Device;
  SampleRing<RecordedSample> Ring;
  RecordedSample Current;
  bool IsPending = false;
};

/// The recording as a trajectory with the device's columns, its tips by the loop's mapping. A
/// sample that is not valid has a tip of 0, and so has one whose position or velocity is not
/// finite: it is not valid in the trajectory. A sent force that is not finite becomes 0, and not
/// taken.
PALPATE_EXPORT Trajectory trajectoryOf(
  const std::vector<RecordedSample>& samples, const WorkspaceMapping& mapping);
} // namespace palpate

#endif
