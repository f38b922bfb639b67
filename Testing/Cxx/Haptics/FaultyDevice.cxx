// SPDX-License-Identifier: BSD-3-Clause
#include "FaultyDevice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
/// Increments a count. Only the servo thread calls this function.
void count(std::atomic<std::uint64_t>& number) noexcept
{
  number.store(number.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

DeviceSample again(DeviceSample sample)
{
  sample.fresh = false;
  return sample;
}
} // namespace

FaultyDevice::FaultyDevice(std::unique_ptr<HapticDevice> device, DeviceFaults faults)
  : Device(std::move(device))
  , Faults(std::move(faults))
  , Wrong(fault(this->Faults))
  , Generator(this->Faults.seed)
{
}

const DeviceSpecification& FaultyDevice::specification() const noexcept
{
  return this->Device->specification();
}

DeviceSample FaultyDevice::read(double time) noexcept
{
  const DeviceSample reading = this->Device->read(time);
  if (!this->Wrong.empty() || !std::isfinite(time))
  {
    return {};
  }
  this->strike(time);
  this->Last = this->tell(reading, time);
  this->LastTime = time;
  return this->Last;
}

bool FaultyDevice::writeWrench(const Wrench& wrench) noexcept
{
  if (!this->Wrong.empty() || this->IsGone.load(std::memory_order_relaxed))
  {
    count(this->Unsent);
    return false;
  }
  return this->isStruck(DeviceFault::Stall) || this->Device->writeWrench(wrench);
}

std::string FaultyDevice::status() const
{
  if (!this->Wrong.empty())
  {
    return "not connected: " + this->Wrong;
  }
  return this->IsGone.load(std::memory_order_relaxed)
    ? "disconnected, by a fault that was asked for"
    : this->Device->status();
}

DeviceErrors FaultyDevice::errors() const noexcept
{
  DeviceErrors errors = this->Device->errors();
  errors.lost += this->Lost.load(std::memory_order_relaxed);
  errors.unsent += this->Unsent.load(std::memory_order_relaxed);
  errors.disconnections += this->Disconnections.load(std::memory_order_relaxed);
  return errors;
}

/// Determines the faults that occur at the reading of this time.
void FaultyDevice::strike(double time) noexcept
{
  for (std::size_t kind = 0; kind < DeviceFaultCount; ++kind)
  {
    Strike& strike = this->Strikes[kind];
    const FaultRate& rate = this->Faults.rates[kind];
    const bool falls = this->draw() < rate.probability;
    strike.begins = falls;
    if (falls)
    {
      strike.end = std::max(strike.end, time + rate.duration);
    }
    strike.is = falls || time < strike.end;
  }
  for (const ScheduledFault& scheduled : this->Faults.schedule)
  {
    Strike& strike = this->Strikes[static_cast<std::size_t>(scheduled.fault)];
    if (scheduled.start <= time && this->LastTime < scheduled.start)
    {
      strike.is = true;
      strike.begins = true;
      strike.end = std::max(strike.end, scheduled.start + scheduled.duration);
    }
  }
}

/// Returns the sample that replaces the reading. The most severe fault takes precedence.
DeviceSample FaultyDevice::tell(const DeviceSample& reading, double time) noexcept
{
  const bool isGone = this->isStruck(DeviceFault::Disconnect);
  if (isGone)
  {
    if (!this->IsGone.load(std::memory_order_relaxed))
    {
      count(this->Disconnections);
      this->Device->write(Eigen::Vector3d::Zero());
    }
    this->IsGone.store(true, std::memory_order_relaxed);
    this->IsLate = false;
    return {};
  }
  this->IsGone.store(false, std::memory_order_relaxed);
  if (this->isStruck(DeviceFault::Stall))
  {
    return again(this->Last);
  }
  const Strike& late = this->Strikes[static_cast<std::size_t>(DeviceFault::Late)];
  if (this->IsLate && time >= this->LateDue)
  {
    this->IsLate = false;
    return this->Late;
  }
  if (late.begins && !this->IsLate)
  {
    this->IsLate = true;
    this->Late = reading;
    this->LateDue = late.end;
  }
  if (this->IsLate)
  {
    return again(this->Last);
  }
  if (this->isStruck(DeviceFault::Dropped))
  {
    count(this->Lost);
    return again(this->Last);
  }
  DeviceSample told = reading;
  if (this->isStruck(DeviceFault::Repeated))
  {
    told = this->Last;
    told.fresh = true;
  }
  else if (this->isStruck(DeviceFault::NotANumber))
  {
    told.position.setConstant(std::numeric_limits<double>::quiet_NaN());
    told.velocity = told.position;
  }
  return told;
}

double FaultyDevice::draw() noexcept
{
  this->Generator += 0x9E3779B97F4A7C15U;
  std::uint64_t bits = this->Generator;
  bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
  bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
  bits ^= bits >> 31U;
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}
} // namespace palpate
