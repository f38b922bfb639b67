// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLoop.h"

#include "FaultyDevice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate::testing
{
namespace
{
bool hasFaults(const DeviceFaults& faults)
{
  return !faults.schedule.empty() ||
    std::any_of(faults.rates.begin(), faults.rates.end(),
      [](const FaultRate& rate) { return rate.probability > 0.0; });
}
} // namespace

DeviceSpecification LoopSetting::specification() const
{
  DeviceSpecification specification;
  specification.rate = this->rate;
  specification.maximumForce = 2.0 * StrongestPush;
  specification.maximumStiffness = 0.5 * this->passiveStiffness();
  specification.delay = this->statedDelay;
  return specification;
}

int LoopSetting::watchedTicks() const
{
  const double share =
    0.5 * (this->plant.damping + this->hand.damping) * this->period() / this->plant.mass;
  return static_cast<int>(std::clamp(0.1 / (0.005 * share), 1000.0, 200000.0));
}

VirtualLoop::VirtualLoop(const LoopSetting& setting, std::vector<WayPoint> path,
  Rendering& rendering, const DeviceFaults& faults)
  : Setting(setting)
  , Rendered(rendering)
  , Audit(setting.plant.damping, setting.period(),
      static_cast<int>(std::lround(setting.plant.forceDelay * setting.rate)))
{
  auto device = std::make_unique<SimulatedDevice>(
    setting.plant, setting.hand, std::move(path), setting.specification());
  this->Device = device.get();
  this->Port = std::move(device);
  if (hasFaults(faults))
  {
    this->Port = std::make_unique<FaultyDevice>(std::move(this->Port), faults);
  }
}

void VirtualLoop::tick()
{
  this->Time = this->Ticks * this->Setting.period();
  const DeviceSample sample = this->Port->read(this->Time);
  this->Audit.moved(this->position());
  const bool isStalled =
    this->Time >= this->Setting.hostStalls && this->Time < this->Setting.hostGoesOn;
  if (!isStalled)
  {
    this->Force = this->Rendered.force(sample, this->Time);
    this->ToldTime = this->Time;
  }
  else if (this->Time - this->ToldTime > this->Rendered.holdTime())
  {
    this->Force.setZero();
  }
  this->Bad += !this->Force.allFinite();
  const Eigen::Vector3d weight(0.0, 0.0, -this->Setting.push);
  this->Port->write(this->Force + weight);
  // Faults may keep a force from the device. A force that is not finite has no effect on the plant.
  const Eigen::Vector3d& last = this->Device->lastForce();
  this->Acting = last.allFinite() ? last - weight : Eigen::Vector3d(Eigen::Vector3d::Zero());
  this->Audit.told(this->Acting, this->Rendered.isFree() && this->Acting.norm() == 0.0);
  this->Peak = std::max(this->Peak, this->Acting.norm());
  ++this->Ticks;
  this->Time = this->Ticks * this->Setting.period();
}

void VirtualLoop::run(int ticks)
{
  for (int i = 0; i < ticks; ++i)
  {
    this->tick();
  }
}

double VirtualLoop::peakSpeed(int ticks)
{
  double peak = 0.0;
  for (int i = 0; i < ticks; ++i)
  {
    this->tick();
    peak = std::max(peak, this->velocity().norm());
  }
  return peak;
}

std::vector<double> VirtualLoop::heights(int ticks)
{
  std::vector<double> heights;
  for (int i = 0; i < ticks; ++i)
  {
    this->tick();
    heights.push_back(this->position().z());
  }
  return heights;
}

double VirtualLoop::swing(int ticks)
{
  const std::vector<double> heights = this->heights(ticks);
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  return *high - *low;
}

void VirtualLoop::forgetPeaks() noexcept
{
  this->Peak = 0.0;
  this->Bad = 0;
}
} // namespace palpate::testing
