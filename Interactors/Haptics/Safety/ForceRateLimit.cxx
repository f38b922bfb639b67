// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/ForceRateLimit.h"

#include <cmath>

namespace palpate
{
Eigen::Vector3d ForceRateLimit::limit(double time, const Eigen::Vector3d& force) const noexcept
{
  if (this->Rate > 0.0 && std::isinf(this->Rate))
  {
    return force;
  }
  const double passed = this->HasTime ? time - this->LastTime : 0.0;
  const double most = this->Rate * passed;
  const Eigen::Vector3d change = force - this->Last;
  const double size = change.stableNorm();
  if (size <= most)
  {
    return force;
  }
  return most > 0.0 ? Eigen::Vector3d(this->Last + most / size * change) : this->Last;
}

void ForceRateLimit::sent(double time, const Eigen::Vector3d& force) noexcept
{
  this->Last = force;
  this->LastTime = time;
  this->HasTime = true;
}

void ForceRateLimit::reset() noexcept
{
  this->Last.setZero();
  this->HasTime = false;
}
} // namespace palpate
