// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/SteeredDevice.h"

namespace palpate
{
SteeredDevice::SteeredDevice(const Eigen::Vector3d& start, const DeviceSpecification& specification)
  : Limits(specification)
  , Target(start)
{
}

DeviceSample SteeredDevice::read(double time) noexcept
{
  DeviceSample sample;
  sample.valid = this->Target.moveOn(time);
  sample.position = this->Target.position();
  return sample;
}

bool SteeredDevice::write(const Eigen::Vector3d&) noexcept
{
  return true;
}
} // namespace palpate
