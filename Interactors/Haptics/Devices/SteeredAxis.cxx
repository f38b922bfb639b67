// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/SteeredAxis.h"

#include <cmath>

namespace palpate
{
void SteeredAxis::turnTo(const Eigen::Vector3d& axis) noexcept
{
  if (axis.allFinite())
  {
    this->Told.write(axis);
  }
}

void SteeredAxis::moveOn(double time) noexcept
{
  const double elapsed = this->HasTime ? time - this->LastTime : 0.0;
  this->LastTime = time;
  this->HasTime = std::isfinite(time);
  const Eigen::Vector3d& told = this->Told.read();
  if (!isTold(this->Orientation) || told.isZero(0.0))
  {
    this->Orientation = orientationAlong(told);
    return;
  }
  if (elapsed > 0.0)
  {
    const Eigen::Vector3d axis = shaftOf(this->Orientation);
    const Eigen::Vector3d left = leastTurn(axis, told);
    this->Orientation = turnedBy(-std::expm1(-elapsed / TimeConstant) * left) * this->Orientation;
    this->Orientation.normalize();
  }
}
} // namespace palpate
