// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Simulation/SimulatedMotion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double FastestRate = 1e5; // Hz

/// Forces that can be on their way at once, if ticks come up to four times faster than specified.
std::size_t pendingForces(const SimulatedPlant& plant, double rate)
{
  return 4 + static_cast<std::size_t>(4.0 * rate * (plant.forceDelay + plant.sampleDelay));
}

std::string faultOf(
  const SimulatedPlant& plant, const HandModel& hand, const TimedPath& path, double rate)
{
  for (const std::string& fault : { palpate::fault({ plant, hand }), path.fault() })
  {
    if (!fault.empty())
    {
      return fault;
    }
  }
  return rate > 0.0 && rate <= FastestRate ? "" : "rate must be above 0, to 100000 Hz";
}
} // namespace

SimulatedMotion::SimulatedMotion(const SimulatedPlant& plant, const HandModel& hand, TimedPath path,
  const Eigen::Vector3d& start, double rate)
  : Plant(plant)
  , Axis(plant, hand)
  , Path(std::move(path))
  , Steered(this->Path.isEmpty() ? std::make_unique<SteeredTarget>(start) : nullptr)
  , Fault(faultOf(plant, hand, this->Path, rate))
  , Pending(this->Fault.empty() ? pendingForces(plant, rate) : 1)
{
  if (this->Fault.empty() && !start.allFinite())
  {
    this->Fault = "the start is not finite";
  }
}

DeviceSample SimulatedMotion::read(double time) noexcept
{
  if (!this->Fault.empty() || !std::isfinite(time))
  {
    return {};
  }
  if (time <= this->LastTime)
  {
    DeviceSample again = this->Last;
    again.fresh = false;
    return again;
  }
  if (std::isnan(this->Clock))
  {
    this->begin(time - this->Plant.sampleDelay);
  }
  else
  {
    this->advanceTo(time - this->Plant.sampleDelay);
  }
  this->Last = this->measure(time);
  this->LastTime = time;
  return this->Last;
}

bool SimulatedMotion::write(const Eigen::Vector3d& force) noexcept
{
  const bool isFinite = force.allFinite();
  const TimedForce sent{ this->LastTime + this->Plant.forceDelay,
    isFinite ? force : Eigen::Vector3d(Eigen::Vector3d::Zero()) };
  const std::size_t size = this->Pending.size();
  TimedForce& newest = this->Pending[(this->First + this->Count + size - 1) % size];
  if (this->Count > 0 && (newest.start == sent.start || this->Count == size))
  {
    newest.force = sent.force;
    return isFinite;
  }
  this->Pending[(this->First + this->Count) % size] = sent;
  ++this->Count;
  return isFinite;
}

void SimulatedMotion::steerTo(const Eigen::Vector3d& target) noexcept
{
  if (this->Steered)
  {
    this->Steered->steerTo(target);
  }
}

Eigen::Vector3d SimulatedMotion::position() const noexcept
{
  return { this->States[0].position, this->States[1].position, this->States[2].position };
}

Eigen::Vector3d SimulatedMotion::velocity() const noexcept
{
  return { this->States[0].velocity, this->States[1].velocity, this->States[2].velocity };
}

void SimulatedMotion::begin(double time) noexcept
{
  this->Clock = time;
  if (this->Steered)
  {
    this->Steered->moveOn(time);
  }
  const Eigen::Vector3d start = this->Steered ? this->Steered->position() : this->Path.at(time);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->States[axis] = { start[axis], 0.0 };
  }
}

void SimulatedMotion::advanceTo(double time) noexcept
{
  TimedPath::Ramp steered;
  const double from = this->Clock;
  if (this->Steered)
  {
    steered.position = this->Steered->position();
    this->Steered->moveOn(time);
    steered.velocity = (this->Steered->position() - steered.position) / (time - from);
    steered.end = std::numeric_limits<double>::infinity();
  }
  // Bounded by the way points and the forces on their way.
  while (this->Clock < time)
  {
    this->hold();
    TimedPath::Ramp target = this->Steered ? steered : this->Path.rampAt(this->Clock);
    if (this->Steered)
    {
      target.position += (this->Clock - from) * steered.velocity;
    }
    double end = std::min(time, target.end);
    if (this->Count > 0)
    {
      end = std::min(end, this->Pending[this->First].start);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->States[axis] = this->Axis.advance(this->States[axis],
        { this->Held[axis], target.position[axis], target.velocity[axis] }, end - this->Clock);
    }
    this->Clock = end;
  }
}

void SimulatedMotion::hold() noexcept
{
  while (this->Count > 0 && this->Pending[this->First].start <= this->Clock)
  {
    this->Held = this->Pending[this->First].force;
    this->First = (this->First + 1) % this->Pending.size();
    --this->Count;
  }
}

DeviceSample SimulatedMotion::measure(double time) const noexcept
{
  DeviceSample sample;
  sample.position = this->position();
  sample.velocity = this->velocity();
  const double step = this->Plant.encoderStep;
  if (step > 0.0)
  {
    for (double& coordinate : sample.position)
    {
      coordinate = step * std::round(coordinate / step);
    }
    const bool isFirst = std::isinf(this->LastTime);
    sample.velocity = isFirst
      ? Eigen::Vector3d(Eigen::Vector3d::Zero())
      : Eigen::Vector3d((sample.position - this->Last.position) / (time - this->LastTime));
  }
  sample.valid = sample.position.allFinite();
  return sample;
}
} // namespace palpate
