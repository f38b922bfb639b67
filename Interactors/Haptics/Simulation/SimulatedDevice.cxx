// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Simulation/SimulatedDevice.h"

#include <cmath>
#include <utility>

namespace palpate
{
SimulatedDevice::SimulatedDevice(
  std::vector<WayPoint> path, const DeviceSpecification& specification)
  : Limits(specification)
  , Path(std::move(path))
  , Duration(this->Path.duration())
{
}

SimulatedDevice::SimulatedDevice(
  const Eigen::Vector3d& start, const DeviceSpecification& specification)
  : Limits(specification)
  , Path({})
  , Target(std::make_unique<SteeredTarget>(start))
{
}

SimulatedDevice::SimulatedDevice(const SimulatedPlant& plant, const HandModel& hand,
  std::vector<WayPoint> path, const DeviceSpecification& specification)
  : Limits(specification)
  , Path({})
  , Duration(path.empty() ? 0.0 : path.back().time)
{
  const Eigen::Vector3d start =
    path.empty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : path.front().position;
  this->Motion = std::make_unique<SimulatedMotion>(
    plant, hand, TimedPath(std::move(path)), start, specification.rate);
}

SimulatedDevice::SimulatedDevice(const SimulatedPlant& plant, const HandModel& hand,
  const Eigen::Vector3d& start, const DeviceSpecification& specification)
  : Limits(specification)
  , Path({})
  , Motion(std::make_unique<SimulatedMotion>(plant, hand, TimedPath({}), start, specification.rate))
{
}

DeviceSample SimulatedDevice::read(double time) noexcept
{
  if (this->Motion)
  {
    return this->Motion->read(time);
  }
  DeviceSample sample;
  if (this->Target)
  {
    sample.valid = this->Target->moveOn(time);
    sample.position = this->Target->position();
    this->Shaft.moveOn(time);
    sample.orientation = this->Shaft.orientation();
    return sample;
  }
  sample.valid = !this->Path.isEmpty() && std::isfinite(time);
  if (sample.valid)
  {
    sample.position = this->Path.at(time);
    sample.orientation = orientationAlong(this->Path.axisAt(time));
  }
  return sample;
}

bool SimulatedDevice::writeWrench(const Wrench& wrench) noexcept
{
  this->Last = wrench;
  return !this->Motion || this->Motion->write(wrench);
}

std::string SimulatedDevice::status() const
{
  return !this->Motion || this->Motion->fault().empty() ? HapticDevice::status()
                                                        : "not simulated: " + this->Motion->fault();
}

void SimulatedDevice::steerTo(const Eigen::Vector3d& target) noexcept
{
  if (SteeredTarget* steered = this->steered())
  {
    steered->steerTo(target);
  }
}

SteeredTarget* SimulatedDevice::steered() noexcept
{
  return this->Motion ? this->Motion->steered() : this->Target.get();
}

void SimulatedDevice::setBody(
  std::shared_ptr<const ContactBody> body, const WorkspaceMapping& mapping)
{
  SteeredTarget* target = this->steered();
  if (target && !this->Planner.hasBody())
  {
    target->setMapping(mapping);
  }
  this->Planner.setBody(std::move(body));
}

void SimulatedDevice::touch(
  const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double height)
{
  SteeredTarget* target = this->steered();
  if (target && this->Planner.hasBody() && point.allFinite() && normal.allFinite() &&
    std::isfinite(height))
  {
    target->touch(this->Planner.plan(point, normal, height));
    this->Planner.release(target->oldestBody());
  }
}

void SimulatedDevice::turnTo(const Eigen::Vector3d& axis) noexcept
{
  if (this->Motion)
  {
    this->Motion->turnTo(axis);
  }
  else if (this->Target)
  {
    this->Shaft.turnTo(axis);
  }
}

Eigen::Vector3d SimulatedDevice::truePosition() const noexcept
{
  return this->Motion ? this->Motion->position() : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

Eigen::Vector3d SimulatedDevice::trueVelocity() const noexcept
{
  return this->Motion ? this->Motion->velocity() : Eigen::Vector3d(Eigen::Vector3d::Zero());
}
} // namespace palpate
