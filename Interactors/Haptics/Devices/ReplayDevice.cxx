// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/ReplayDevice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
/// The double that lies `steps` representable numbers above `value`; `steps` may be negative.
double further(double value, int steps)
{
  const double towards = std::copysign(std::numeric_limits<double>::infinity(), steps);
  for (int i = 0; i < std::abs(steps); ++i)
  {
    value = std::nextafter(value, towards);
  }
  return value;
}

/// Returns the position that the mapping maps exactly to `tip`, bit for bit, if there is one near
/// the inverse image of `tip`.
Eigen::Vector3d positionOf(const Eigen::Vector3d& tip, const WorkspaceMapping& mapping)
{
  // Largest error of two multiplications, in units of the last place, upwards and downwards.
  constexpr int Reach = 3;
  Eigen::Vector3d guess = mapping.toDevice(tip);
  if (mapping.toBody(guess) == tip)
  {
    return guess;
  }
  Eigen::Vector3d position = guess;
  for (int i = -Reach; i <= Reach; ++i)
  {
    position.x() = further(guess.x(), i);
    for (int j = -Reach; j <= Reach; ++j)
    {
      position.y() = further(guess.y(), j);
      for (int k = -Reach; k <= Reach; ++k)
      {
        position.z() = further(guess.z(), k);
        if (mapping.toBody(position) == tip)
        {
          return position;
        }
      }
    }
  }
  return guess;
}
} // namespace

ReplayDevice::ReplayDevice(const Trajectory& trajectory, const WorkspaceMapping& mapping,
  const DeviceSpecification& specification)
  : Limits(specification)
{
  this->Rows.reserve(trajectory.rows.size());
  for (const TrajectoryRow& row : trajectory.rows)
  {
    Row played{ row.time, row.sample };
    if (!trajectory.hasDevice)
    {
      played.sample = {};
      played.sample.valid = row.hasTip();
      played.sample.position =
        row.hasTip() ? positionOf(row.tip, mapping) : Eigen::Vector3d(Eigen::Vector3d::Zero());
    }
    if (trajectory.hasAxis)
    {
      played.sample.orientation = orientationAlong(mapping.axisToDevice(row.axis));
    }
    this->Rows.push_back(played);
  }
}

DeviceSample ReplayDevice::read(double time) noexcept
{
  if (this->Rows.empty() || !std::isfinite(time))
  {
    return {};
  }
  const auto to = std::upper_bound(this->Rows.begin(), this->Rows.end(), time,
    [](double t, const Row& row) { return t < row.time; });
  if (to == this->Rows.begin())
  {
    return this->Rows.front().sample;
  }
  const Row& from = *(to - 1);
  if (to == this->Rows.end() || from.time == time)
  {
    return from.sample;
  }
  DeviceSample sample = from.sample;
  sample.fresh = to->sample.fresh;
  if (from.sample.valid && to->sample.valid)
  {
    const double share = (time - from.time) / (to->time - from.time);
    sample.position += share * (to->sample.position - from.sample.position);
    sample.velocity += share * (to->sample.velocity - from.sample.velocity);
    if (isTold(from.sample.orientation) && isTold(to->sample.orientation))
    {
      const Eigen::Vector3d way =
        leastTurn(shaftOf(from.sample.orientation), shaftOf(to->sample.orientation));
      sample.orientation = turnedBy(share * way) * from.sample.orientation;
    }
  }
  return sample;
}

bool ReplayDevice::writeWrench(const Wrench& wrench) noexcept
{
  this->Last = wrench;
  return true;
}
} // namespace palpate
