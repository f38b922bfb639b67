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

/// The rotation vector of an orientation; zero if the orientation is unknown.
Eigen::Vector3d turnOf(const ToolOrientation& orientation) noexcept
{
  return isTold(orientation) ? turnBetween(ToolOrientation::Identity(), orientation)
                             : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

/// Largest number of delayed forces. Ticks may be up to four times as frequent as specified.
std::size_t pendingForces(const SimulatedPlant& plant, double rate)
{
  return 4 + static_cast<std::size_t>(4.0 * rate * (plant.forceDelay + plant.sampleDelay));
}

/// Returns the plant of rotations, in which angles replace displacements and torques replace
/// forces.
SimulatedPlant turningPlant(const SimulatedPlant& plant)
{
  SimulatedPlant turning;
  turning.mass = plant.inertia;
  turning.damping = plant.turnDamping;
  return turning;
}

HandModel turningHand(const HandModel& hand)
{
  HandModel turning;
  turning.stiffness = hand.turnStiffness;
  turning.damping = hand.turnHandDamping;
  return turning;
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
  , TurningAxis(turningPlant(plant), turningHand(hand))
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

bool SimulatedMotion::write(const Wrench& wrench) noexcept
{
  const bool isFinite = wrench.isFinite();
  const TimedForce sent{ this->LastTime + this->Plant.forceDelay, isFinite ? wrench : Wrench() };
  const std::size_t size = this->Pending.size();
  TimedForce& newest = this->Pending[(this->First + this->Count + size - 1) % size];
  if (this->Count > 0 && (newest.start == sent.start || this->Count == size))
  {
    newest.wrench = sent.wrench;
    return isFinite;
  }
  this->Pending[(this->First + this->Count) % size] = sent;
  ++this->Count;
  return isFinite;
}

void SimulatedMotion::turnTo(const Eigen::Vector3d& axis) noexcept
{
  if (this->Steered)
  {
    this->SteeredShaft.turnTo(axis);
  }
}

ToolOrientation SimulatedMotion::targetOrientation(double time) const noexcept
{
  return this->Steered ? this->SteeredShaft.orientation()
                       : orientationAlong(this->Path.axisAt(time));
}

Eigen::Vector3d SimulatedMotion::position() const noexcept
{
  return { this->States[0].position, this->States[1].position, this->States[2].position };
}

Eigen::Vector3d SimulatedMotion::velocity() const noexcept
{
  return { this->States[0].velocity, this->States[1].velocity, this->States[2].velocity };
}

Eigen::Vector3d SimulatedMotion::rotation() const noexcept
{
  return { this->Turns[0].position, this->Turns[1].position, this->Turns[2].position };
}

void SimulatedMotion::begin(double time) noexcept
{
  this->Clock = time;
  if (this->Steered)
  {
    this->Steered->moveOn(time);
    this->SteeredShaft.moveOn(time);
  }
  const Eigen::Vector3d start = this->Steered ? this->Steered->position() : this->Path.at(time);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->States[axis] = { start[axis], 0.0 };
  }
  const ToolOrientation held = this->targetOrientation(time);
  if (isTold(held))
  {
    this->beginTurn(turnOf(held));
  }
}

void SimulatedMotion::advanceTo(double time) noexcept
{
  TimedPath::Ramp steered;
  const double from = this->Clock;
  const ToolOrientation heldBefore = this->targetOrientation(from);
  if (this->Steered)
  {
    steered.position = this->Steered->position();
    this->Steered->moveOn(time);
    this->SteeredShaft.moveOn(time);
    steered.velocity = (this->Steered->position() - steered.position) / (time - from);
    steered.end = std::numeric_limits<double>::infinity();
  }
  const ToolOrientation held = this->targetOrientation(time);
  if (isTold(held) && !this->IsTurned)
  {
    this->beginTurn(turnOf(held));
  }
  const Eigen::Vector3d meantFrom = turnOf(isTold(heldBefore) ? heldBefore : held);
  const Eigen::Vector3d turning = (turnOf(held) - meantFrom) / (time - from);
  // Each interval ends at a way point or at the start of a delayed force.
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
        { this->Held.force[axis], target.position[axis], target.velocity[axis] },
        end - this->Clock);
    }
    if (this->turns() && this->IsTurned)
    {
      this->turn(meantFrom + (this->Clock - from) * turning, turning, end - this->Clock);
    }
    this->Clock = end;
  }
}

void SimulatedMotion::beginTurn(const Eigen::Vector3d& rotation) noexcept
{
  this->IsTurned = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Turns[axis] = { rotation[axis], 0.0 };
  }
}

void SimulatedMotion::turn(
  const Eigen::Vector3d& target, const Eigen::Vector3d& rate, double duration) noexcept
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Turns[axis] = this->TurningAxis.advance(
      this->Turns[axis], { this->Held.torque[axis], target[axis], rate[axis] }, duration);
  }
}

void SimulatedMotion::hold() noexcept
{
  while (this->Count > 0 && this->Pending[this->First].start <= this->Clock)
  {
    this->Held = this->Pending[this->First].wrench;
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
  if (this->turns() && this->IsTurned)
  {
    sample.orientation = turnedBy(this->rotation());
  }
  else
  {
    sample.orientation = this->targetOrientation(this->Clock);
  }
  sample.valid = sample.position.allFinite() && sample.orientation.coeffs().allFinite();
  return sample;
}
} // namespace palpate
