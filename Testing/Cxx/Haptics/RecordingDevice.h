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
/// Reading and force of a device in one tick, in the device's frame and SI units.
struct RecordedSample
{
  double time = 0.0;
  DeviceSample sample;
  Eigen::Vector3d force = Eigen::Vector3d::Zero(); ///< the written force; zero if none was written
  bool isTaken = false;                            ///< whether the device has accepted the force
};

/**
 * Records another device: every reading with its time and the force written after it, in a
 * preallocated ring (SampleRing). Readings and forces are passed on unchanged.
 *
 * A recording contains only data of the device: its frame, no contact, no mapping. trajectoryOf
 * converts a recording for a file. A ReplayDevice then reads the same bits from the file.
 *
 * read and write are for the servo thread; drain may run in one other thread at the same time. If
 * it is called often enough, the length of the recording is unlimited. Otherwise the newest
 * readings are lost and counted (overruns). A reading is stored when its force is written or when
 * the next reading is made. The last reading before the end of a loop is therefore stored only if
 * its force was written. Further forces for the same reading, such as the zero force that a loop
 * sends when it stops, are passed on but not stored.
 */
class PALPATE_EXPORT RecordingDevice final : public HapticDevice
{
public:
  /// `capacity`: largest number of readings between two drains, 150 bytes each.
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

  /// Appends the records since the last call.
  void drain(std::vector<RecordedSample>& samples);
  /// Number of readings that did not fit.
  std::uint64_t overruns() const noexcept { return this->Ring.overruns(); }
  HapticDevice& device() noexcept { return *this->Device; }

private:
  std::unique_ptr<HapticDevice> Device;
  SampleRing<RecordedSample> Ring;
  RecordedSample Current;
  bool IsPending = false;
};

/// Converts a recording to a trajectory with the columns of the device. The mapping of the loop
/// gives the tips. The tip is 0 for an invalid sample. A sample whose position or velocity is not
/// finite becomes invalid. A sent force that is not finite becomes 0 and "not taken".
PALPATE_EXPORT Trajectory trajectoryOf(
  const std::vector<RecordedSample>& samples, const WorkspaceMapping& mapping);
} // namespace palpate

#endif
