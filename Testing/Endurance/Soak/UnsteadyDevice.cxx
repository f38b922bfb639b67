// SPDX-License-Identifier: BSD-3-Clause
#include "UnsteadyDevice.h"

#include <cmath>
#include <ctime>
#include <limits>
#include <utility>

namespace palpate::endurance
{
namespace
{
/// Increments a number that only the servo thread changes.
void add(std::atomic<std::uint64_t>& number) noexcept
{
  number.store(number.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}
} // namespace

UnsteadyDevice::UnsteadyDevice(const DeviceSpecification& specification, std::size_t capacity)
  : Limits(specification)
  , Records(capacity)
{
}

void UnsteadyDevice::offer(std::unique_ptr<PluggedDevice> device)
{
  this->Wants.store(false);
  this->Devices.offer(std::move(device));
  this->Devices.collect();
}

void UnsteadyDevice::plug(double time) noexcept
{
  if (this->Current && time - this->Since >= this->Current->life)
  {
    this->Devices.giveBack(std::move(this->Current));
    this->Since = time;
    add(this->Unplugs);
  }
  if (!this->Next)
  {
    this->Next = this->Devices.take();
    if (this->Next)
    {
      this->Wants.store(true);
    }
  }
  if (!this->Current && this->Next && time - this->Since >= this->Next->absence)
  {
    this->Current = std::move(this->Next);
    this->Since = time;
  }
}

void UnsteadyDevice::hang(double time) noexcept
{
  if (this->Current && time - this->Since >= this->Current->hangAt)
  {
    this->Current->hangAt = std::numeric_limits<double>::infinity();
    const timespec pause{ 0, static_cast<long>(this->Current->hangFor * 1e9) };
    nanosleep(&pause, nullptr);
    add(this->Hangs);
  }
}

void UnsteadyDevice::count(const DeviceSample& told) noexcept
{
  if (!told.valid)
  {
    add(this->Absent);
  }
  else if (!told.position.allFinite())
  {
    add(this->NotANumber);
  }
  else if (!told.fresh)
  {
    add(this->Dropped);
  }
  else if (told.position != this->Current->hand->last().position)
  {
    add(this->Late);
  }
}

DeviceSample UnsteadyDevice::read(double time) noexcept
{
  this->plug(time);
  this->hang(time);
  DeviceSample sample;
  if (this->Current)
  {
    sample = this->Current->device->read(time - this->Since);
  }
  this->count(sample);
  this->Open.time = time;
  this->Open.sample = sample;
  this->IsOpen = true;
  return sample;
}

bool UnsteadyDevice::write(const Eigen::Vector3d& force) noexcept
{
  this->LastForce = force;
  if (std::exchange(this->IsOpen, false))
  {
    this->Open.sent = force;
    this->Records.push(this->Open);
  }
  return this->Current && this->Current->device->write(force);
}

DeviceTroubles UnsteadyDevice::troubles() const
{
  return { this->Unplugs.load(), this->Absent.load(), this->NotANumber.load(), this->Dropped.load(),
    this->Late.load(), this->Hangs.load() };
}
} // namespace palpate::endurance
