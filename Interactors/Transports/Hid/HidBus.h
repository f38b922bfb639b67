// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HidBus_h
#define palpate_HidBus_h

#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// A HID device in the system's list. Unknown members are empty or 0.
struct HidEntry
{
  std::string path; ///< "/dev/hidraw3"
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::uint16_t usagePage = 0;
  std::uint16_t usage = 0;
  std::string maker;
  std::string name; ///< name of the product
  std::string serial;
};

/// An open HID device. read is for one thread, the other functions for one other thread, unless the
/// threads use separate ports.
class PALPATE_EXPORT HidPort
{
public:
  virtual ~HidPort() = default;
  /// Waits for a report, at most `milliseconds`. Returns its length, truncated to `size`; 0 if
  /// there is no report; −1 if the device is disconnected.
  virtual int read(std::uint8_t* bytes, std::size_t size, int milliseconds) noexcept = 0;
  /// Sends an unnumbered output report. May block for as long as the device blocks.
  virtual bool write(const std::uint8_t* bytes, std::size_t size) noexcept = 0;
  /// Requests the unnumbered feature report. Returns its length, or −1 if the device has none.
  virtual int feature(std::uint8_t* bytes, std::size_t size) noexcept = 0;
};

/// Lists and opens HID devices: the devices of the system (through hidapi), or simulated devices
/// for a test. For any thread except a servo thread.
class PALPATE_EXPORT HidBus
{
public:
  virtual ~HidBus() = default;
  virtual std::vector<HidEntry> entries() = 0;
  /// Opens a device. If the device cannot be opened, returns null and sets `error` to the reason.
  virtual std::unique_ptr<HidPort> open(const std::string& path, std::string& error) = 0;
  /// Returns the reason why the device cannot be opened; empty if no reason is known.
  virtual std::string obstacle(const std::string& path) = 0;
  /// Returns the reason why the list cannot have entries; empty if there is no such reason.
  virtual std::string complaint() const { return {}; }
};

/// The system's devices, by hidapi. If Palpate was built without hidapi (PALPATE_USE_HIDAPI), the
/// bus has no entries and a complaint.
PALPATE_EXPORT HidBus& systemHidBus();
} // namespace palpate

#endif
