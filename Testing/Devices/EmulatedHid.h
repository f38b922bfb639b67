// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_EmulatedHid_h
#define palpate_testing_EmulatedHid_h

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace palpate::testing
{
/// Properties that a USB device reports.
struct HidModel
{
  std::uint16_t vendor = 0x1209; ///< pid.codes, for tests
  std::uint16_t product = 0x0001;
  std::string maker = "Somebody";
  std::string name = "Palpate test device";
  std::string serial = "42";
  std::vector<std::uint8_t> reportDescriptor;
  std::vector<std::uint8_t>
    feature; ///< bytes without the report's number; empty if there is no feature report
};

class UhidDevice;

/**
 * A USB HID device emulated by umockdev. This process sees it as /dev/hidrawN and in /sys. The code
 * that opens the device is the real hidapi. The process must run under umockdev-wrapper.
 * A real hidraw delivers whole reports, but the emulated hidraw is a stream of bytes (a
 * pseudo-terminal). Therefore a test that sends a report of a different length must wait until the
 * report has been read.
 */
class EmulatedHid
{
public:
  /// Plugs the device in under a number that has not been used before, because umockdev cannot
  /// reuse numbers.
  explicit EmulatedHid(HidModel model);
  /// Unplugs the device.
  ~EmulatedHid();
  EmulatedHid(const EmulatedHid&) = delete;
  EmulatedHid& operator=(const EmulatedHid&) = delete;

  const std::string& path() const { return this->Path; }
  /// Device → host. Returns false if the device is unplugged or no program reads.
  bool send(const std::uint8_t* bytes, std::size_t size);
  /// Host → device: gets the next output report, without its number. Returns false if there is
  /// none.
  bool receive(std::vector<std::uint8_t>& report, std::size_t size);
  void unplug();

private:
  bool flush();

  HidModel Model;
  std::string Path;
  std::vector<std::string> Nodes; ///< in /sys, outermost first
  std::mutex Mutex;
  int Far = -1;                      ///< file descriptor of the device's end; protected by Mutex
  std::vector<std::uint8_t> Unsent;  ///< rest of a report that did not fit
  std::vector<std::uint8_t> Pending; ///< beginning of a received report
  /// Replaces the previous four members on a real kernel (kernel/).
  std::shared_ptr<UhidDevice> Uhid;
};
} // namespace palpate::testing

#endif
