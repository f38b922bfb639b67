// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/SteeredTarget.h"

#include <cmath>
#include <limits>

namespace palpate
{
SteeredTarget::SteeredTarget(const Eigen::Vector3d& start)
  : Told(start)
  , Position(start)
  , LastTime(std::numeric_limits<double>::quiet_NaN())
{
}

bool SteeredTarget::moveOn(double time) noexcept
{
  const Eigen::Vector3d& told = this->Told.read();
  const double elapsed = time - this->LastTime; // NaN in the first tick
  const bool isFinite = told.allFinite();
  if (elapsed > 0.0 && isFinite)
  {
    this->Position = told + std::exp(-elapsed / TimeConstant) * (this->Position - told);
  }
  this->LastTime = time;
  return isFinite;
}
} // namespace palpate
