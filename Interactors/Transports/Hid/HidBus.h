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
/// An entry of the system's list of HID devices. Unknown members are empty or 0.
struct HidEntry
{
  std::string path; ///< such as "/dev/hidraw3"
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::uint16_t usagePage = 0;
  std::uint16_t usage = 0;
  std::string maker;
  std::string name; ///< name of the product
  std::string serial;
};

/// An open HID device. One thread may call read, and one other thread the other functions. Threads
/// with separate ports are independent.
class PALPATE_EXPORT HidPort
{
public:
  virtual ~HidPort() = default;
  /// Waits at most `milliseconds` for a report. Returns the length of the report, truncated to
  /// `size`. Returns 0 if no report arrived and −1 if the device is disconnected.
  virtual int read(std::uint8_t* bytes, std::size_t size, int milliseconds) noexcept = 0;
  /// Sends an unnumbered output report. May wait as long as the device is busy.
  virtual bool write(const std::uint8_t* bytes, std::size_t size) noexcept = 0;
  /// Requests the unnumbered feature report. Returns the length of the report, or −1 if the device
  /// has none.
  virtual int feature(std::uint8_t* bytes, std::size_t size) noexcept = 0;
};

/// Lists and opens HID devices. These are the devices of the system, through hidapi, or simulated
/// devices for a test. Any thread except a servo thread may use a bus.
class PALPATE_EXPORT HidBus
{
public:
  virtual ~HidBus() = default;
  virtual std::vector<HidEntry> entries() = 0;
  /// Opens a device. If the device cannot be opened, returns null and sets `error` to the reason.
  virtual std::unique_ptr<HidPort> open(const std::string& path, std::string& error) = 0;
  /// Returns the reason why the device cannot be opened. Empty if no reason is known.
  virtual std::string obstacle(const std::string& path) = 0;
  /// Returns the reason why the list cannot have entries. Empty if there is no such reason.
  virtual std::string complaint() const { return {}; }
};

/// The bus of the system's devices, which uses hidapi. If Palpate was built without hidapi
/// (PALPATE_USE_HIDAPI), the bus has no entries, and complaint() returns the reason.
PALPATE_EXPORT HidBus& systemHidBus();
} // namespace palpate

#endif
