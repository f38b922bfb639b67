// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ReplayDevice_h
#define palpate_ReplayDevice_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Devices/Trajectory.h"
#include "Haptics/Devices/WorkspaceMapping.h"

#include <vector>

namespace palpate
{
/**
 * Replays a trajectory as a device: a hand that repeats the same path, whatever the force.
 *
 * The times of the file are those of the loop. At the time of a row the sample is the recorded one
 * to the bit: position, velocity, buttons, valid, fresh. Of several rows of equal time the last one
 * is used. Between two rows position and velocity are linear in time, at any rate of the loop; next
 * to a row that is not valid they are constant. Before the first row and after the last one
 * (isAtEnd) the hand rests at that row.
 *
 * An axis is replayed as the smallest rotation that gives it, exact to rounding. Between two rows
 * with an axis the shaft turns at constant speed.
 *
 * Frames: a file has the tip (body frame, mm). A recording (RecordingDevice) also has the device's
 * position. This position is then replayed, so that the loop may have another mapping than the
 * recording. Without it the tip is mapped back through `mapping`, which the loop must use too. The
 * result is a position whose image is the tip to the bit; with a rotation in the mapping the last
 * bit may differ. Rows without a tip are samples that are not valid.
 */
class PALPATE_EXPORT ReplayDevice final : public HapticDevice
{
public:
  /// The times of the rows must not decrease (readTrajectory). Without rows no sample is valid.
  ReplayDevice(const Trajectory& trajectory, const WorkspaceMapping& mapping,
    const DeviceSpecification& specification = {});

  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  /// Not valid if `time` is not finite. O(log n).
  DeviceSample read(double time) noexcept override;
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    return this->writeWrench({ force, Eigen::Vector3d::Zero() });
  }
  bool writeWrench(const Wrench& wrench) noexcept override;

  const Eigen::Vector3d& lastForce() const noexcept { return this->Last.force; }
  const Eigen::Vector3d& lastTorque() const noexcept { return this->Last.torque; }
  /// Times of the first and the last row, s; 0 without rows.
  double begin() const noexcept { return this->Rows.empty() ? 0.0 : this->Rows.front().time; }
  double duration() const noexcept { return this->Rows.empty() ? 0.0 : this->Rows.back().time; }
  bool isAtEnd(double time) const noexcept { return time >= this->duration(); }

private:
  struct Row
  {
    double time = 0.0;
    DeviceSample sample;
  };

  DeviceSpecification Limits;
  std::vector<Row> Rows;
  Wrench Last;
};
} // namespace palpate

#endif
