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
/// A HID device in the system's list. Unknown fields are empty or 0.
struct HidEntry
{
  std::string path; ///< "/dev/hidraw3"
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::uint16_t usagePage = 0;
  std::uint16_t usage = 0;
  std::string maker;
  std::string name; ///< of the product
  std::string serial;
};

/// An open HID device. read is for one thread, the rest for one other, unless they use two ports.
class PALPATE_EXPORT HidPort
{
public:
  virtual ~HidPort() = default;
  /// Waits for a report, at most `milliseconds`. Returns its length, cut to `size`; 0: none; −1:
  /// the device is gone.
  virtual int read(std::uint8_t* bytes, std::size_t size, int milliseconds) noexcept = 0;
  /// Sends an unnumbered output report. May block as long as the device does.
  virtual bool write(const std::uint8_t* bytes, std::size_t size) noexcept = 0;
  /// Requests the unnumbered feature report. Returns its length; −1: it has none.
  virtual int feature(std::uint8_t* bytes, std::size_t size) noexcept = 0;
};

/// Lists and opens HID devices: the system's, by hidapi, or simulated ones for a test. For any
/// thread but a servo thread.
class PALPATE_EXPORT HidBus
{
public:
  virtual ~HidBus() = default;
  virtual std::vector<HidEntry> entries() = 0;
  /// Null, and why in words, if it cannot be opened.
  virtual std::unique_ptr<HidPort> open(const std::string& path, std::string& error) = 0;
  /// Why it cannot be opened, in words; empty: nothing known.
  virtual std::string obstacle(const std::string& path) = 0;
  /// Why there can be no entries, in words; empty: there can be.
  virtual std::string complaint() const { return {}; }
};

/// The system's devices, by hidapi; a bus without entries, and with a complaint, if Palpate was
/// built without it (PALPATE_USE_HIDAPI).
PALPATE_EXPORT HidBus& systemHidBus();
} // namespace palpate

#endif
