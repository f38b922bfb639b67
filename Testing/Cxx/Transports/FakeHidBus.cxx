// SPDX-License-Identifier: BSD-3-Clause
#include "FakeHidBus.h"

#include <algorithm>
#include <utility>

namespace palpate::testing
{
class FakeHidDevice::Port final : public HidPort
{
public:
  explicit Port(std::shared_ptr<FakeHidDevice> device)
    : Device(std::move(device))
  {
    const std::lock_guard<std::mutex> lock(this->Device->Mutex);
    ++this->Device->Ports;
  }
  ~Port() override
  {
    const std::lock_guard<std::mutex> lock(this->Device->Mutex);
    --this->Device->Ports;
  }

  int read(std::uint8_t* bytes, std::size_t size, int milliseconds) noexcept override
  {
    FakeHidDevice& device = *this->Device;
    std::unique_lock<std::mutex> lock(device.Mutex);
    device.Changed.wait_for(lock, std::chrono::milliseconds(milliseconds),
      [&device] { return !device.Sent.empty() || !device.Plugged; });
    if (!device.Plugged)
    {
      return -1;
    }
    if (device.Sent.empty())
    {
      return 0;
    }
    const std::size_t count = std::min(size, device.Sent.front().size());
    std::copy_n(device.Sent.front().begin(), count, bytes);
    device.Sent.pop_front();
    return static_cast<int>(count);
  }

  bool write(const std::uint8_t* bytes, std::size_t size) noexcept override
  {
    FakeHidDevice& device = *this->Device;
    std::unique_lock<std::mutex> lock(device.Mutex);
    const auto time = device.WriteTime;
    if (time.count() > 0)
    {
      lock.unlock();
      std::this_thread::sleep_for(time);
      lock.lock();
    }
    device.Changed.wait(lock, [&device] { return !device.Hanging; });
    if (!device.Plugged || device.Refusing)
    {
      return false;
    }
    device.Written.emplace_back(bytes, bytes + size);
    return true;
  }

  int feature(std::uint8_t* bytes, std::size_t size) noexcept override
  {
    const std::vector<std::uint8_t>& feature = this->Device->Feature;
    if (feature.empty() || feature.size() > size)
    {
      return -1;
    }
    std::copy(feature.begin(), feature.end(), bytes);
    return static_cast<int>(feature.size());
  }

private:
  std::shared_ptr<FakeHidDevice> Device;
};

void FakeHidDevice::send(const std::uint8_t* bytes, std::size_t size)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Sent.emplace_back(bytes, bytes + size);
  this->Changed.notify_all();
}

void FakeHidDevice::unplug()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Plugged = false;
  this->Changed.notify_all();
}

void FakeHidDevice::setWriteTime(std::chrono::milliseconds time)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->WriteTime = time;
}

void FakeHidDevice::hang(bool yes)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Hanging = yes;
  this->Changed.notify_all();
}

void FakeHidDevice::refuse(bool yes)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Refusing = yes;
}

std::vector<std::vector<std::uint8_t>> FakeHidDevice::written() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Written;
}

ForceReport FakeHidDevice::lastForce() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  ForceReport report;
  if (!this->Written.empty())
  {
    parse(this->Written.back().data(), this->Written.back().size(), report);
  }
  return report;
}

int FakeHidDevice::openPorts() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Ports;
}

void FakeHidBus::plug(std::shared_ptr<FakeHidDevice> device)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Devices.push_back(std::move(device));
}

void FakeHidBus::unplug(const std::string& path)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const auto gone = std::find_if(this->Devices.begin(), this->Devices.end(),
    [&path](const auto& device) { return device->Entry.path == path; });
  if (gone != this->Devices.end())
  {
    (*gone)->unplug();
    this->Devices.erase(gone);
  }
}

void FakeHidBus::setObstacle(const std::string& path, const std::string& words)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->ObstaclePath = path;
  this->Obstacle = words;
}

std::vector<HidEntry> FakeHidBus::entries()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  std::vector<HidEntry> entries;
  for (const auto& device : this->Devices)
  {
    entries.push_back(device->Entry);
  }
  return entries;
}

std::unique_ptr<HidPort> FakeHidBus::open(const std::string& path, std::string& error)
{
  error = this->obstacle(path);
  const std::lock_guard<std::mutex> lock(this->Mutex);
  for (const auto& device : this->Devices)
  {
    if (error.empty() && device->Entry.path == path)
    {
      return std::make_unique<FakeHidDevice::Port>(device);
    }
  }
  error = error.empty() ? "there is no " + path : error;
  return nullptr;
}

std::string FakeHidBus::obstacle(const std::string& path)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return path == this->ObstaclePath ? this->Obstacle : std::string();
}
} // namespace palpate::testing
