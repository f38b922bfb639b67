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
/// What a USB device says of itself.
struct HidModel
{
  std::uint16_t vendor = 0x1209; ///< pid.codes, for tests
  std::uint16_t product = 0x0001;
  std::string maker = "Somebody";
  std::string name = "Palpate test device";
  std::string serial = "42";
  std::vector<std::uint8_t> reportDescriptor;
  std::vector<std::uint8_t> feature; ///< without the report's number; empty: it has none
};

class UhidDevice;

/**
 * A USB HID device that the process sees as /dev/hidrawN and in /sys, by umockdev: what opens it is
 * the real hidapi. The process must run under umockdev-wrapper.
 *
 * Where a real hidraw hands over whole reports this one is a stream of bytes (a pseudo-terminal):
 * after a report of another length the test waits until it has been read.
 */
class EmulatedHid
{
public:
  /// Plugs it in, under a number that has not been used before (umockdev knows no other way).
  explicit EmulatedHid(HidModel model);
  /// Unplugs it.
  ~EmulatedHid();
  EmulatedHid(const EmulatedHid&) = delete;
  EmulatedHid& operator=(const EmulatedHid&) = delete;

  const std::string& path() const { return this->Path; }
  /// Device → host. False when it is unplugged, or nobody reads.
  bool send(const std::uint8_t* bytes, std::size_t size);
  /// Host → device: the next output report, without its number. False when there is none.
  bool receive(std::vector<std::uint8_t>& report, std::size_t size);
  void unplug();

private:
  bool flush();

  HidModel Model;
  std::string Path;
  std::vector<std::string> Nodes; ///< in /sys, the outermost first
  std::mutex Mutex;
  int Far = -1;                      ///< under Mutex: the device's end
  std::vector<std::uint8_t> Unsent;  ///< the end of a report for which there was no room
  std::vector<std::uint8_t> Pending; ///< the beginning of a report that has come
  std::shared_ptr<UhidDevice> Uhid;  ///< instead of the last four, on a real kernel (kernel/)
};
} // namespace palpate::testing

#endif
