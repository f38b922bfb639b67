// SPDX-License-Identifier: BSD-3-Clause
#include "SimulatedDevice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
SimulatedDevice::SimulatedDevice(
  std::vector<WayPoint> path, const DeviceSpecification& specification)
  : Limits(specification)
  , Path(std::move(path))
{
}

DeviceSample SimulatedDevice::read(double time) noexcept
{
  DeviceSample sample;
  if (this->Path.empty() || !std::isfinite(time))
  {
    return sample;
  }
  sample.valid = true;
  const auto after = std::upper_bound(this->Path.begin(), this->Path.end(), time,
    [](double t, const WayPoint& point) { return t < point.time; });
  if (after == this->Path.begin())
  {
    sample.position = this->Path.front().position;
  }
  else if (after == this->Path.end())
  {
    sample.position = this->Path.back().position;
  }
  else
  {
    const WayPoint& from = *(after - 1);
    const double share = (time - from.time) / (after->time - from.time);
    sample.position = from.position + share * (after->position - from.position);
  }
  return sample;
}

bool SimulatedDevice::write(const Eigen::Vector3d& force) noexcept
{
  this->Force = force;
  return true;
}

double SimulatedDevice::duration() const noexcept
{
  return this->Path.empty() ? 0.0 : this->Path.back().time;
}
} // namespace palpate
