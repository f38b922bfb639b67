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
 * Replays a trajectory as a device: a hand that repeats the recorded path and ignores the force.
 *
 * The times of the file are those of the loop. At the time of a row the sample is the recorded one
 * bit for bit: position, velocity, buttons, valid, fresh. If several rows have the same time, the
 * last of them is used. Between two rows position and velocity are linear in time, at any rate of
 * the loop; next to a row that is not valid they are constant. Before the first row the hand rests
 * at that row, after the last row (isAtEnd) at the last row.
 *
 * An axis is replayed as the smallest rotation that results in this axis, exact to rounding.
 * Between two rows with an axis the shaft turns at constant speed.
 *
 * Frames: a file contains the tip (body frame, mm). A recording (RecordingDevice) also contains the
 * device's position. In that case this position is replayed, so that the loop may have another
 * mapping than the recording. Otherwise the tip is mapped back through `mapping`, which the loop
 * must use too. The result is a position whose image is the tip bit for bit; with a rotation in the
 * mapping the last bit may differ. Rows without a tip are samples that are not valid.
 */
class PALPATE_EXPORT ReplayDevice final : public HapticDevice
{
public:
  /// The times of the rows must not decrease (readTrajectory). If there are no rows, no sample is
  /// valid.
  ReplayDevice(const Trajectory& trajectory, const WorkspaceMapping& mapping,
    const DeviceSpecification& specification = {});

  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  /// The sample is not valid if `time` is not finite. O(log n).
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
