// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/SteeredTarget.h"

#include <cmath>
#include <limits>

namespace palpate
{
SteeredTarget::SteeredTarget(const Eigen::Vector3d& start)
  : Newest(Told{ start, TouchGoal() })
  , Position(start)
  , LastTime(std::numeric_limits<double>::quiet_NaN())
{
}

void SteeredTarget::steerTo(const Eigen::Vector3d& target) noexcept
{
  this->Newest.write({ target, TouchGoal() });
}

void SteeredTarget::touch(const TouchGoal& goal) noexcept
{
  this->Newest.write({ this->Mapping.toDevice(goal.tip()), goal });
}

bool SteeredTarget::moveOn(double time) noexcept
{
  const Told& told = this->Newest.read();
  const double elapsed = time - this->LastTime; // NaN in the first tick
  this->LastTime = time;
  const bool isFinite = told.target.allFinite();
  if (told.goal.number > 0 && isFinite)
  {
    this->moveGuided(told.goal, elapsed);
  }
  else if (isFinite)
  {
    this->IsGuided = false;
    if (elapsed > 0.0)
    {
      this->Position =
        told.target + std::exp(-elapsed / TimeConstant) * (this->Position - told.target);
    }
  }
  this->HasBegun = true;
  return isFinite;
}

void SteeredTarget::moveGuided(const TouchGoal& goal, double elapsed) noexcept
{
  if (!this->HasBegun)
  {
    this->Hand.beginAt(goal);
  }
  else if (!this->IsGuided)
  {
    this->Hand.putAt(this->Mapping.toBody(this->Position));
  }
  this->IsGuided = true;
  this->Hand.follow(goal);
  if (elapsed > 0.0)
  {
    this->Hand.advance(elapsed);
  }
  this->Position = this->Mapping.toDevice(this->Hand.tip());
  this->Oldest.store(this->Hand.oldestBody(), std::memory_order_release);
}
} // namespace palpate
