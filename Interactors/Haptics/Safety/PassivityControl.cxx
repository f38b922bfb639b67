// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/PassivityControl.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
/// Largest credit of a hold, as a multiple of K_max. It limits the credit of a hold that is much
/// shorter than the period, for example after a late tick.
constexpr double LargestCredit = 2.0;

double positive(double value) noexcept
{
  return value > 0.0 ? value : 0.0;
}

double leverOf(double stiffness, double torsionalStiffness) noexcept
{
  const bool isCounted = stiffness > 0.0 && std::isfinite(stiffness) && torsionalStiffness > 0.0 &&
    std::isfinite(torsionalStiffness);
  return isCounted ? std::sqrt(torsionalStiffness / stiffness) : 0.0;
}
} // namespace

PassivityControl::PassivityControl(
  double maximumStiffness, double period, double delay, double maximumTorsionalStiffness) noexcept
  : Stiffness(positive(maximumStiffness))
  , Period(period)
  , Delay(positive(delay))
  , TorsionalStiffness(positive(maximumTorsionalStiffness))
  , Lever(leverOf(maximumStiffness, maximumTorsionalStiffness))
  , UnderWay(delay, period)
{
}

SpatialVector PassivityControl::scaled(const Wrench& wrench) const noexcept
{
  SpatialVector force;
  force.linear = wrench.force;
  if (this->Lever > 0.0)
  {
    force.angular = wrench.torque / this->Lever;
  }
  return force;
}

[[gnu::hot]] SpatialVector PassivityControl::movedTo(
  const Eigen::Vector3d& position, const ToolOrientation& orientation) const noexcept
{
  SpatialVector moved;
  moved.linear = position - this->Position;
  if (this->Lever > 0.0 && isTold(this->Orientation) && isTold(orientation))
  {
    moved.angular = this->Lever * turnBetween(this->Orientation, orientation);
  }
  return moved;
}

double PassivityControl::givenByTurn() const noexcept
{
  const double most = this->Force.angular.squaredNorm();
  return most > 0.0 ? 0.5 * static_cast<double>(this->UnderWay.late() + 1) * most / this->Stiffness
                    : 0.0;
}

[[gnu::hot]] void PassivityControl::observe(
  double time, const Eigen::Vector3d& position, const ToolOrientation& orientation) noexcept
{
  if (this->HasPosition && std::isfinite(this->Stiffness))
  {
    const SpatialVector moved = this->movedTo(position, orientation);
    const double passed = time - this->ReadTime;
    // If several ticks passed without a new reading, the mean force is used, as if the hand had
    // moved at constant speed.
    const SpatialVector held =
      passed > 0.0 ? (this->Impulse + (time - this->SentTime) * this->Force) / passed : this->Force;
    const double credit =
      passed * LargestCredit > this->Period ? this->Period / passed : LargestCredit;
    const double given = this->UnderWay.late() > 0
      ? this->UnderWay.mostGiven(moved, this->SentTicks)
      : held.dot(moved);
    this->Energy += this->IsInterrupted
      ? -this->givenInGap(moved)
      : 0.5 * credit * this->Share * this->Stiffness * moved.squaredNorm() - given;
    if (!isTold(orientation) || !isTold(this->Orientation))
    {
      this->Energy -= this->givenByTurn();
    }
    // not finite, for example, after a jump of 1e150 m
    this->Energy = std::isfinite(this->Energy) ? this->Energy : 0.0;
    this->Velocity = passed > 0.0 ? moved / passed : this->Velocity;
  }
  this->HasPosition = true;
  this->Position = position;
  this->Orientation = orientation;
  this->ReadTime = time;
  this->SentTime = time;
  this->Impulse = {};
  this->IsInterrupted = false;
  this->SentTicks = 0;
}

double PassivityControl::givenInGap(const SpatialVector& moved) const noexcept
{
  const double force = this->Taken.norm();
  const double most = this->Stiffness > 0.0 ? 0.5 * force * force / this->Stiffness : 0.0;
  const double time = this->Held + this->Delay;
  double along = 0.0;
  if (force > 0.0)
  {
    const SpatialVector direction = this->Taken / force;
    const double handle = this->handleAlong(direction);
    along = force * (this->wayOfHand(direction, time) + 0.5 * force / handle * time * time);
  }
  const auto holds = static_cast<double>(this->UnderWay.late() + 1);
  return std::min(holds * most, std::max(this->Taken.dot(moved), along));
}

/// The largest acceleration along a direction, m/s², that the hand produces without the force.
double PassivityControl::accelerationOfHand(const SpatialVector& direction) const noexcept
{
  return direction.isAngular() ? direction.linear.norm() * HandAcceleration +
      direction.angular.norm() * this->Lever * HandTurning
                               : HandAcceleration;
}

/// The smallest mass along a direction that the force can accelerate, kg.
double PassivityControl::handleAlong(const SpatialVector& direction) const noexcept
{
  const double lever = this->Lever;
  return direction.isAngular() ? 1.0 /
      (direction.linear.squaredNorm() / LightestHandle +
        direction.angular.squaredNorm() * lever * lever / LightestInertia)
                               : LightestHandle;
}

/// The largest displacement along a direction, m, that the hand produces in `time` (s) without the
/// force.
double PassivityControl::wayOfHand(const SpatialVector& direction, double time) const noexcept
{
  return std::max(0.0, direction.dot(this->Velocity)) * time +
    0.5 * this->accelerationOfHand(direction) * time * time;
}

/// The largest magnitude of a force that may be sent while earlier, delayed forces may still act.
double PassivityControl::allowedUnderWay(
  const SpatialVector& force, double size, double energy) const noexcept
{
  const double unconditional = this->UnderWay.largestWithin(2.0 * this->Stiffness * energy);
  if (!(size > unconditional))
  {
    return unconditional;
  }
  // Solves f (way + f t²/2m) = E for f, where way is the displacement of the hand and t the
  // duration of all holds.
  const double time = this->Period * static_cast<double>(this->UnderWay.late() + 1);
  const SpatialVector direction = force / size;
  const double way = this->wayOfHand(direction, time);
  const double perForce = 0.5 * time * time / this->handleAlong(direction);
  const double most = (std::sqrt(way * way + 4.0 * perForce * energy) - way) / (2.0 * perForce);
  return std::max(unconditional, most);
}

double PassivityControl::storable(double force, double depth, double torque) const noexcept
{
  const auto holds = static_cast<double>(this->UnderWay.late() + 1);
  const double turning =
    this->Lever > 0.0 ? 0.5 * holds * torque * torque / this->TorsionalStiffness : 0.0;
  const double least =
    (this->Stiffness > 0.0 ? 0.5 * holds * force * force / this->Stiffness : 0.0) + turning;
  return std::max(least, force > 0.0 ? force * depth : 0.0);
}

[[gnu::hot]] void PassivityControl::bound(double force, double depth, double torque) noexcept
{
  if (depth >= 0.0)
  {
    this->Energy = std::min(this->Energy, this->storable(force, depth, torque));
  }
  this->Share = force > 0.0 || torque > 0.0 ? this->Share : 1.0;
}

void PassivityControl::grant(double force, double depth, double torque) noexcept
{
  this->Energy =
    std::max(this->Energy, this->storable(force, std::isfinite(depth) ? depth : 0.0, torque));
  this->Share = 1.0;
}

[[gnu::hot]] double PassivityControl::allowed(const SpatialVector& force, double size) noexcept
{
  const double energy = std::max(this->Energy + Slack, 0.0);
  const double most = this->UnderWay.late() > 0 ? this->allowedUnderWay(force, size, energy)
                                                : std::sqrt(2.0 * this->Stiffness * energy);
  if (size > most)
  {
    this->Share = std::clamp(most / size, SmallestShare, this->Share);
  }
  return std::sqrt(this->Share) * most;
}

Eigen::Vector3d PassivityControl::limit(const Eigen::Vector3d& force) noexcept
{
  return this->limit(Wrench{ force, Eigen::Vector3d::Zero() }).force;
}

[[gnu::hot]] Wrench PassivityControl::limit(const Wrench& wrench) noexcept
{
  Wrench passed = wrench;
  if (!(this->TorsionalStiffness > 0.0))
  {
    passed.torque.setZero();
  }
  if (std::isinf(this->Stiffness))
  {
    return passed;
  }
  const SpatialVector force = this->scaled(passed);
  const double size = force.stableNorm();
  const double most = this->allowed(force, size);
  if (!(size <= most))
  {
    passed.force *= most / size;
    passed.torque *= this->Lever > 0.0 ? most / size : 1.0;
  }
  return passed;
}

void PassivityControl::sent(double time, const Eigen::Vector3d& force) noexcept
{
  this->send(time, { force, Eigen::Vector3d::Zero() });
}

[[gnu::hot]] void PassivityControl::sent(double time, const Wrench& wrench) noexcept
{
  this->send(time, this->scaled(wrench));
}

[[gnu::hot]] void PassivityControl::send(double time, const SpatialVector& force) noexcept
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

[[gnu::hot]] double PassivityControl::holdTime() const noexcept
{
  const double force = this->Force.norm();
  if (!(force > 0.0) || std::isinf(this->Stiffness))
  {
    return std::numeric_limits<double>::infinity();
  }
  // Solves F (v t + a t²/2) = E for the time t, with the acceleration a of hand and handle.
  const double speed = std::max(0.0, this->Force.dot(this->Velocity) / force);
  const SpatialVector direction = this->Force / force;
  const double acceleration =
    this->accelerationOfHand(direction) + force / this->handleAlong(direction);
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
  this->send(time, {});
}

double PassivityControl::spare() const noexcept
{
  const bool isKnown =
    this->HasPosition && !this->IsInterrupted && this->SentTicks <= 1 && this->UnderWay.late() == 0;
  if (!isKnown || !std::isfinite(this->Stiffness) || !(this->Stiffness > 0.0))
  {
    return 0.0;
  }
  const double needed = this->Force.squaredNorm() / (2.0 * this->Share * this->Stiffness);
  return std::max(0.0, this->Energy - needed);
}

void PassivityControl::reset() noexcept
{
  *this = PassivityControl(this->Stiffness, this->Period, this->Delay, this->TorsionalStiffness);
}
} // namespace palpate
