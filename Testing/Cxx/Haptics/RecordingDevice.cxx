// SPDX-License-Identifier: BSD-3-Clause
#include "RecordingDevice.h"

#include <utility>

namespace palpate
{
RecordingDevice::RecordingDevice(std::unique_ptr<HapticDevice> device, std::size_t capacity)
  : Device(std::move(device))
  , Ring(capacity)
{
}

const DeviceSpecification& RecordingDevice::specification() const noexcept
{
  return this->Device->specification();
}

DeviceSample RecordingDevice::read(double time) noexcept
{
  if (this->IsPending)
  {
    this->Ring.push(this->Current);
  }
  this->Current = {};
  this->Current.time = time;
  this->Current.sample = this->Device->read(time);
  this->IsPending = true;
  return this->Current.sample;
}

bool RecordingDevice::writeWrench(const Wrench& wrench) noexcept
{
  const bool isTaken = this->Device->writeWrench(wrench);
  if (this->IsPending)
  {
    this->Current.force = wrench.force;
    this->Current.isTaken = isTaken;
    this->Ring.push(this->Current);
    this->IsPending = false;
  }
  return isTaken;
}

void RecordingDevice::drain(std::vector<RecordedSample>& samples)
{
  this->Ring.drain([&](const RecordedSample& sample) { samples.push_back(sample); });
}

Trajectory trajectoryOf(const std::vector<RecordedSample>& samples, const WorkspaceMapping& mapping)
{
  Trajectory trajectory;
  trajectory.hasDevice = true;
  trajectory.rows.reserve(samples.size());
  for (const RecordedSample& recorded : samples)
  {
    TrajectoryRow row;
    row.time = recorded.time;
    row.sample = recorded.sample;
    if (!row.sample.position.allFinite() || !row.sample.velocity.allFinite())
    {
      row.sample.position.setZero();
      row.sample.velocity.setZero();
      row.sample.valid = false;
    }
    if (row.sample.valid)
    {
      row.tip = mapping.toBody(row.sample.position);
      row.axis = mapping.axisToBody(shaftOf(row.sample.orientation));
      trajectory.hasAxis = trajectory.hasAxis || !row.axis.isZero(0.0);
    }
    if (recorded.force.allFinite())
    {
      row.sentForce = recorded.force;
      row.isTaken = recorded.isTaken;
    }
    trajectory.rows.push_back(row);
  }
  return trajectory;
}
} // namespace palpate
