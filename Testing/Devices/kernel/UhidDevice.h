// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_UhidDevice_h
#define palpate_testing_UhidDevice_h

#include "EmulatedHid.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace palpate::testing
{
/**
 * A HID device that this process plugs into the real kernel by /dev/uhid. It appears as a real
 * /dev/hidrawN, with the queues, reports and unplugging of the kernel. A thread answers the
 * requests of the kernel.
 */
class UhidDevice
{
public:
  /// Throws std::runtime_error if the kernel rejects the device, or if no hidraw appears within 5
  /// s.
  explicit UhidDevice(const HidModel& model);
  ~UhidDevice();
  UhidDevice(const UhidDevice&) = delete;
  UhidDevice& operator=(const UhidDevice&) = delete;

  const std::string& path() const { return this->Path; }
  /// Device → host. Returns false if the device is unplugged.
  bool send(const std::uint8_t* bytes, std::size_t size);
  /// Host → device: gets the next output report, without its number. Returns false if there is
  /// none.
  bool receive(std::vector<std::uint8_t>& report);
  /// Removes the device by UHID_DESTROY, even if it is open.
  void unplug();

private:
  void create(const HidModel& model, const std::string& phys);
  void serve();
  void answerFeature(std::uint32_t id);

  std::vector<std::uint8_t> Feature;
  int File = -1;
  std::string Path;
  std::mutex Mutex;
  std::deque<std::vector<std::uint8_t>> Reports; ///< reports from the host; protected by Mutex
  std::atomic<bool> Plugged{ false };
  std::atomic<bool> Stopping{ false };
  std::thread Thread;
};
} // namespace palpate::testing

#endif
