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
    feature; ///< without the report's number; empty if there is no feature report
};

class UhidDevice;

/**
 * A USB HID device that this process sees as /dev/hidrawN and in /sys, emulated by umockdev. The
 * code that opens it is the real hidapi. The process must run under umockdev-wrapper.
 * A real hidraw delivers whole reports; this one is a stream of bytes (a pseudo-terminal). After a
 * report of a different length a test must wait until it has been read.
 */
class EmulatedHid
{
public:
  /// Plugs the device in, under a number that has not been used before (a limitation of umockdev).
  explicit EmulatedHid(HidModel model);
  /// Unplugs it.
  ~EmulatedHid();
  EmulatedHid(const EmulatedHid&) = delete;
  EmulatedHid& operator=(const EmulatedHid&) = delete;

  const std::string& path() const { return this->Path; }
  /// Device → host. False if it is unplugged or if no program reads.
  bool send(const std::uint8_t* bytes, std::size_t size);
  /// Host → device: the next output report, without its number. False if there is none.
  bool receive(std::vector<std::uint8_t>& report, std::size_t size);
  void unplug();

private:
  bool flush();

  HidModel Model;
  std::string Path;
  std::vector<std::string> Nodes; ///< in /sys, outermost first
  std::mutex Mutex;
  int Far = -1;                      ///< under Mutex: the file descriptor of the device's end
  std::vector<std::uint8_t> Unsent;  ///< rest of a report for which there was no room
  std::vector<std::uint8_t> Pending; ///< beginning of a received report
  std::shared_ptr<UhidDevice> Uhid;  ///< replaces the last four on a real kernel (kernel/)
};
} // namespace palpate::testing

#endif
