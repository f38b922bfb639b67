// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_FakeHidBus_h
#define palpate_testing_FakeHidBus_h

#include "Transports/Hid/HapticReport.h"
#include "Transports/Hid/HidBus.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace palpate::testing
{
/// The device's end of a fake HID device: sent and received reports, and its faults.
class FakeHidDevice
{
public:
  explicit FakeHidDevice(const HidEntry& entry)
    : Entry(entry)
  {
  }

  HidEntry Entry;
  std::vector<std::uint8_t> Feature; ///< empty: no feature report

  void send(const std::uint8_t* bytes, std::size_t size);
  template <class Report>
  void send(const Report& report)
  {
    HapticReportBytes bytes;
    pack(report, bytes);
    this->send(bytes.data(), bytes.size());
  }

  /// Reads and writes fail from now on.
  void unplug();
  /// Sets the duration of each write.
  void setWriteTime(std::chrono::milliseconds time);
  /// `yes`: writes do not return until released.
  void hang(bool yes);
  /// `yes`: writes fail although the device is plugged in.
  void refuse(bool yes);

  /// Returns all reports that were sent to the device so far.
  std::vector<std::vector<std::uint8_t>> written() const;
  ForceReport lastForce() const; ///< a default report if there is none or if the last is invalid
  int openPorts() const;

private:
  class Port;
  friend class FakeHidBus;

  mutable std::mutex Mutex;
  std::condition_variable Changed;
  std::deque<std::vector<std::uint8_t>> Sent;
  std::vector<std::vector<std::uint8_t>> Written;
  std::chrono::milliseconds WriteTime{ 0 };
  bool Plugged = true;
  bool Hanging = false;
  bool Refusing = false;
  int Ports = 0;
};

/// A bus with fake devices. It must outlive its users.
class FakeHidBus final : public HidBus
{
public:
  void plug(std::shared_ptr<FakeHidDevice> device);
  /// Unplugs a device and removes it from the list.
  void unplug(const std::string& path);
  void setObstacle(const std::string& path, const std::string& words);

  std::vector<HidEntry> entries() override;
  std::unique_ptr<HidPort> open(const std::string& path, std::string& error) override;
  std::string obstacle(const std::string& path) override;

private:
  std::mutex Mutex;
  std::vector<std::shared_ptr<FakeHidDevice>> Devices;
  std::string ObstaclePath;
  std::string Obstacle;
};

/// Waits until the condition holds, at most a minute. Used for actions of another thread, which
/// take milliseconds unless the machine is busy.
template <class Condition>
bool eventually(const Condition& condition)
{
  for (int i = 0; i < 60000; ++i)
  {
    if (condition())
    {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}
} // namespace palpate::testing

#endif
