// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/PassivityControl.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
/// A hold much shorter than the period, such as after a late one, is credited with no more than
/// this multiple of K_max.
constexpr double LargestCredit = 2.0;
} // namespace

PassivityControl::PassivityControl(double maximumStiffness, double period, double delay) noexcept
  : Stiffness(maximumStiffness > 0.0 ? maximumStiffness : 0.0)
  , Period(period)
  , Delay(delay > 0.0 ? delay : 0.0)
  , UnderWay(delay, period)
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
    const double given = this->UnderWay.late() > 0
      ? this->UnderWay.mostGiven(moved, this->SentTicks)
      : held.dot(moved);
    this->Energy += this->IsInterrupted
      ? -this->givenInGap(moved)
      : 0.5 * credit * this->Share * this->Stiffness * moved.squaredNorm() - given;
    this->Energy = std::isfinite(this->Energy) ? this->Energy : 0.0; // a jump of 1e150 m
    this->Velocity = passed > 0.0 ? Eigen::Vector3d(moved / passed) : this->Velocity;
  }
  this->HasPosition = true;
  this->Position = position;
  this->ReadTime = time;
  this->SentTime = time;
  this->Impulse.setZero();
  this->IsInterrupted = false;
  this->SentTicks = 0;
}

double PassivityControl::givenInGap(const Eigen::Vector3d& moved) const noexcept
{
  const double force = this->Taken.norm();
  const double most = this->Stiffness > 0.0 ? 0.5 * force * force / this->Stiffness : 0.0;
  const double time = this->Held + this->Delay;
  const double along = force > 0.0 ? force *
      (this->wayOfHand(this->Taken / force, time) + 0.5 * force / LightestHandle * time * time)
                                   : 0.0;
  const auto holds = static_cast<double>(this->UnderWay.late() + 1);
  return std::min(holds * most, std::max(this->Taken.dot(moved), along));
}

/// How far a hand gets by itself along a direction in so long.
double PassivityControl::wayOfHand(const Eigen::Vector3d& direction, double time) const noexcept
{
  return std::max(0.0, direction.dot(this->Velocity)) * time + 0.5 * HandAcceleration * time * time;
}

/// The size up to which a force may be sent while others are under way.
double PassivityControl::allowedUnderWay(
  const Eigen::Vector3d& force, double size, double energy) const noexcept
{
  const double whatever = this->UnderWay.largestWithin(2.0 * this->Stiffness * energy);
  if (!(size > whatever))
  {
    return whatever;
  }
  // f (way of the hand + f t²/2m) = E
  const double time = this->Period * static_cast<double>(this->UnderWay.late() + 1);
  const double way = this->wayOfHand(force / size, time);
  const double perForce = 0.5 * time * time / LightestHandle;
  const double most = (std::sqrt(way * way + 4.0 * perForce * energy) - way) / (2.0 * perForce);
  return std::max(whatever, most);
}

double PassivityControl::storable(double force, double depth) const noexcept
{
  const auto holds = static_cast<double>(this->UnderWay.late() + 1);
  const double least = this->Stiffness > 0.0 ? 0.5 * holds * force * force / this->Stiffness : 0.0;
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
  const double energy = std::max(this->Energy + Slack, 0.0);
  const double most = this->UnderWay.late() > 0 ? this->allowedUnderWay(force, size, energy)
                                                : std::sqrt(2.0 * this->Stiffness * energy);
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
  if (this->UnderWay.late() > 0)
  {
    this->UnderWay.sent(force);
    ++this->SentTicks;
  }
}

double PassivityControl::holdTime() const noexcept
{
  const double force = this->Force.norm();
  if (!(force > 0.0) || std::isinf(this->Stiffness))
  {
    return std::numeric_limits<double>::infinity();
  }
  // F (v t + a t²/2) = E, a of hand and handle
  const double speed = std::max(0.0, this->Force.dot(this->Velocity) / force);
  const double acceleration = HandAcceleration + force / LightestHandle;
  const double way = std::max(0.0, this->Energy) / force;
  const double time =
    2.0 * way / (speed + std::sqrt(speed * speed + 2.0 * acceleration * way) + 1e-300);
  return std::max(0.0, time - this->Delay);
}

void PassivityControl::interrupt(double time) noexcept
{
  if (!this->IsInterrupted)
  {
    this->Taken = this->Force;
    this->Held = std::max(0.0, time - this->SentTime);
    this->IsInterrupted = true;
  }
  this->sent(time, Eigen::Vector3d::Zero());
}

void PassivityControl::reset() noexcept
{
  *this = PassivityControl(this->Stiffness, this->Period, this->Delay);
}
} // namespace palpate
