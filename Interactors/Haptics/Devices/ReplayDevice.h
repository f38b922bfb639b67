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
 * The times of the file are the times of the loop. At the time of a row the sample is bit for bit
 * the recorded one, with position, velocity, buttons, valid and fresh. If several rows have the
 * same time, the last of them is used. Between two rows, position and velocity are interpolated
 * linearly in time, at any rate of the loop. Next to a row that is not valid, they are constant.
 * Before the first row the hand rests at the position of the first row. After the last row
 * (isAtEnd) it rests at the position of the last row.
 *
 * If a row has an axis, the orientation is the smallest rotation that results in this axis, exact
 * to rounding. Between two rows with an axis the shaft turns at constant speed.
 *
 * A file contains the tip (body frame, mm). A recording (RecordingDevice) also contains the
 * device's position. In that case the device's position is replayed, so that the mapping of the
 * loop may differ from the mapping of the recording. Otherwise the tip is mapped back through
 * `mapping`, which the loop must use too. The loop maps the resulting position to the tip, bit for
 * bit; if the mapping contains a rotation, the last bit may differ. A row without a tip is replayed
 * as a sample that is not valid.
 */
class PALPATE_EXPORT ReplayDevice final : public HapticDevice
{
public:
  /// The times of the rows must not decrease (readTrajectory). Without rows, no sample is valid.
  ReplayDevice(const Trajectory& trajectory, const WorkspaceMapping& mapping,
    const DeviceSpecification& specification = {});

  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  /// The sample is not valid if `time` is not finite. The cost is O(log n) for n rows.
  DeviceSample read(double time) noexcept override;
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    return this->writeWrench({ force, Eigen::Vector3d::Zero() });
  }
  bool writeWrench(const Wrench& wrench) noexcept override;

  const Eigen::Vector3d& lastForce() const noexcept { return this->Last.force; }
  const Eigen::Vector3d& lastTorque() const noexcept { return this->Last.torque; }
  /// Time of the first row and of the last row, s. Both are 0 if there are no rows.
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
