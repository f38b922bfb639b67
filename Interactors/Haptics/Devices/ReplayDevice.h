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
 * Plays a trajectory again as a device: a hand that goes the same way, whatever it feels.
 *
 * The times of the file are those of the loop. At the time of a row the sample is what was recorded
 * (of rows of one time the last), with all its bits: position, velocity, buttons, valid, fresh.
 * Between two rows the position, and the velocity, are linear in time, at any rate of the loop;
 * next to a row that is not valid they stay. Before the first row the hand rests there, after the
 * last one likewise (isAtEnd says so).
 *
 * An axis is played as the least turn that gives it, which is the axis to rounding; between two
 * rows that tell one the shaft turns evenly.
 *
 * Frames: a file tells the tip (body frame, mm); a recording (RecordingDevice) tells the device's
 * position as well, and that is what is played, so that the mapping of the loop may be another than
 * then. Without it the tip is taken back through `mapping`, which the loop must use too, to the
 * position whose image is the tip to the bit: there always is one, and it is found, if the tip was
 * recorded through a mapping without rotation; with one the last bit may differ. Rows without a tip
 * are samples that are not valid.
 */
class PALPATE_EXPORT ReplayDevice final : public HapticDevice
{
public:
  /// The rows' times do not decrease (readTrajectory). Without rows no sample is valid.
  ReplayDevice(const Trajectory& trajectory, const WorkspaceMapping& mapping,
    const DeviceSpecification& specification = {});

  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  /// Not valid where `time` is not finite. O(log n).
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
