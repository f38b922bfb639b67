// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/PassivityControl.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// A hold much shorter than the period, such as after a late one, is credited with no more than
/// this multiple of K_max.
constexpr double LargestCredit = 2.0;
} // namespace

PassivityControl::PassivityControl(double maximumStiffness, double period) noexcept
  : Stiffness(maximumStiffness > 0.0 ? maximumStiffness : 0.0)
  , Period(period)
{
}

void PassivityControl::observe(double time, const Eigen::Vector3d& position) noexcept
{
  if (this->HasPosition && std::isfinite(this->Stiffness))
  {
    const Eigen::Vector3d moved = position - this->Position;
    const double passed = time - this->ReadTime;
    // Several ticks without a new reading: their mean, as if the hand moved evenly.
    const Eigen::Vector3d held = passed > 0.0
      ? Eigen::Vector3d((this->Impulse + (time - this->SentTime) * this->Force) / passed)
      : this->Force;
    const double credit =
      passed * LargestCredit > this->Period ? this->Period / passed : LargestCredit;
    this->Energy +=
      0.5 * credit * this->Share * this->Stiffness * moved.squaredNorm() - held.dot(moved);
    this->Energy = std::isfinite(this->Energy) ? this->Energy : 0.0; // a jump of 1e150 m
  }
  this->HasPosition = true;
  this->Position = position;
  this->ReadTime = time;
  this->SentTime = time;
  this->Impulse.setZero();
}

double PassivityControl::storable(double force, double depth) const noexcept
{
  const double least = this->Stiffness > 0.0 ? 0.5 * force * force / this->Stiffness : 0.0;
  return std::max(least, force > 0.0 ? force * depth : 0.0);
}

void PassivityControl::bound(double force, double depth) noexcept
{
  if (depth >= 0.0)
  {
    this->Energy = std::min(this->Energy, this->storable(force, depth));
  }
  this->Share = force > 0.0 ? this->Share : 1.0;
}

void PassivityControl::grant(double force, double depth) noexcept
{
  this->Energy = std::max(this->Energy, this->storable(force, std::isfinite(depth) ? depth : 0.0));
  this->Share = 1.0;
}

Eigen::Vector3d PassivityControl::limit(const Eigen::Vector3d& force) noexcept
{
  if (std::isinf(this->Stiffness))
  {
    return force;
  }
  const double size = force.stableNorm();
  const double most = std::sqrt(2.0 * this->Stiffness * std::max(this->Energy + Slack, 0.0));
  if (size > most)
  {
    this->Share = std::clamp(most / size, SmallestShare, this->Share);
  }
  const double allowed = std::sqrt(this->Share) * most;
  return size <= allowed ? force : Eigen::Vector3d(allowed / size * force);
}

void PassivityControl::sent(double time, const Eigen::Vector3d& force) noexcept
{
  this->Impulse += (time - this->SentTime) * this->Force;
  this->SentTime = time;
  this->Force = force;
}

void PassivityControl::reset() noexcept
{
  *this = PassivityControl(this->Stiffness, this->Period);
}
} // namespace palpate
