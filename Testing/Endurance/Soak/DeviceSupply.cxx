// SPDX-License-Identifier: BSD-3-Clause
#include "DeviceSupply.h"

#include "FaultyDevice.h"
#include "Haptics/Devices/ReplayDevice.h"
#include "Haptics/Simulation/SimulatedDevice.h"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>

namespace palpate::endurance
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double PathStep = 2e-3; // s

/// Rates that give a few faults of each kind per second at 4 kHz. Faults that suppress the force
/// are rarer, so that there is a force between them.
DeviceFaults faultsOf(std::uint64_t seed)
{
  DeviceFaults faults;
  faults.rate(DeviceFault::NotANumber) = { 5e-5, 0.0 };
  faults.rate(DeviceFault::Repeated) = { 1e-3, 0.0 };
  faults.rate(DeviceFault::Dropped) = { 5e-3, 0.0 };
  faults.rate(DeviceFault::Late) = { 5e-4, 2e-3 };
  faults.rate(DeviceFault::Stall) = { 1e-4, 0.03 };
  faults.rate(DeviceFault::Disconnect) = { 3e-5, 0.01 };
  faults.seed = seed;
  return faults;
}
} // namespace

DeviceSupply::DeviceSupply(const DeviceFrame& frame, const DeviceSpecification& specification,
  const Vector3& centre, double radius, unsigned seed)
  : Frame(frame)
  , Specification(specification)
  , Centre(centre)
  , Radius(radius)
  , Random(seed)
{
}

std::vector<DeviceSupply::Place> DeviceSupply::makePath(double seconds)
{
  constexpr double amplitude = 3.0;               // mm
  const double presses = this->between(0.7, 2.5); // presses per second
  const double phase = this->between(0.0, 2.0 * Pi);
  const double speed = this->between(0.1, 1.0); // rad/s around the body
  const double sway = this->between(0.3, 1.5);  // oscillations per second
  const Eigen::AngleAxisd start(
    this->between(0.0, 2.0 * Pi), Vector3(this->between(-1.0, 1.0), 1.0, 0.4).normalized());
  std::vector<Place> path;
  for (double time = 0.0; time < seconds; time += PathStep)
  {
    const double along = speed * time;
    const double across = 0.3 * std::sin(2.0 * Pi * sway * time);
    const Vector3 direction = start *
      Vector3(
        std::cos(along) * std::cos(across), std::sin(along) * std::cos(across), std::sin(across));
    const double height = amplitude * std::sin(2.0 * Pi * presses * time + phase);
    path.push_back({ time, this->Centre + (this->Radius + height) * direction });
  }
  return path;
}

std::unique_ptr<HapticDevice> DeviceSupply::makeHand(double seconds)
{
  const std::vector<Place> path = this->makePath(seconds);
  if (this->Made % 3 == 2)
  {
    Trajectory trajectory;
    for (const Place& place : path)
    {
      TrajectoryRow row;
      row.time = place.time;
      row.tip = place.tip;
      trajectory.rows.push_back(row);
    }
    return std::make_unique<ReplayDevice>(trajectory,
      WorkspaceMapping(this->Frame.axes, this->Frame.origin, this->Frame.scale),
      this->Specification);
  }
  std::vector<WayPoint> points;
  for (const Place& place : path)
  {
    points.push_back({ place.time, this->Frame.position(place.tip) });
  }
  if (this->Made % 3 == 1)
  {
    HandModel hand;
    hand.stiffness = 800.0;
    return std::make_unique<SimulatedDevice>(
      SimulatedPlant{}, hand, std::move(points), this->Specification);
  }
  return std::make_unique<SimulatedDevice>(std::move(points), this->Specification);
}

std::unique_ptr<PluggedDevice> DeviceSupply::make()
{
  auto made = std::make_unique<PluggedDevice>();
  made->life = this->between(1.0, 6.0);
  made->absence = this->between(0.0, 1.0) < 0.5 ? 0.0 : this->between(0.0, 0.2);
  if (this->Made % 2 == 0)
  {
    made->hangAt = this->between(0.0, made->life);
    made->hangFor = this->between(1e-3, 0.03);
  }
  auto hand = std::make_unique<TrueHand>(this->makeHand(made->life));
  made->hand = hand.get();
  ++this->Made;
  made->device = std::make_unique<FaultyDevice>(std::move(hand), faultsOf(this->Made));
  return made;
}
} // namespace palpate::endurance
