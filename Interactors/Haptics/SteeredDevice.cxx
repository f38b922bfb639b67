// SPDX-License-Identifier: BSD-3-Clause
#include "SteeredDevice.h"

#include <cmath>
#include <limits>

namespace palpate
{
SteeredDevice::SteeredDevice(const Eigen::Vector3d& start, const DeviceSpecification& specification)
  : Limits(specification)
  , Target(start)
  , Position(start)
  , LastTime(std::numeric_limits<double>::quiet_NaN())
{
}

DeviceSample SteeredDevice::read(double time) noexcept
{
  const Eigen::Vector3d& target = this->Target.read();
  const double elapsed = time - this->LastTime; // NaN in the first tick
  if (elapsed > 0.0 && target.allFinite())
  {
    this->Position = target + std::exp(-elapsed / TimeConstant) * (this->Position - target);
  }
  this->LastTime = time;
  DeviceSample sample;
  sample.position = this->Position;
  sample.valid = target.allFinite();
  return sample;
}

bool SteeredDevice::write(const Eigen::Vector3d&) noexcept
{
  return true;
}
} // namespace palpate
