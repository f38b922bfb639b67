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
/// A HID device as the system lists it. What it does not tell is empty or 0.
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

/// A HID device that is open. read is one thread's, the rest one other's, unless they use two
/// ports.
class PALPATE_EXPORT HidPort
{
public:
  virtual ~HidPort() = default;
  /// Waits up to so many milliseconds for a report. Its bytes, cut to `size`; 0: none came; −1: the
  /// device is gone.
  virtual int read(std::uint8_t* bytes, std::size_t size, int milliseconds) noexcept = 0;
  /// Sends an unnumbered output report. May take as long as the device likes.
  virtual bool write(const std::uint8_t* bytes, std::size_t size) noexcept = 0;
  /// Asks for the unnumbered feature report. How many bytes came; −1: it has none.
  virtual int feature(std::uint8_t* bytes, std::size_t size) noexcept = 0;
};

/// Where HID devices are found and opened: the system's, by hidapi, or one made up for a test.
/// Any thread may call it, none of them a servo thread.
class PALPATE_EXPORT HidBus
{
public:
  virtual ~HidBus() = default;
  virtual std::vector<HidEntry> entries() = 0;
  /// Null and why, in words, if it cannot be opened.
  virtual std::unique_ptr<HidPort> open(const std::string& path, std::string& error) = 0;
  /// In words what stands against opening it; empty: nothing known.
  virtual std::string obstacle(const std::string& path) = 0;
  /// In words why there are no entries at all to be had; empty: there are.
  virtual std::string complaint() const { return {}; }
};

/// The system's devices, by hidapi; a bus without entries, and with a complaint, if Palpate was
/// built without it (PALPATE_USE_HIDAPI).
PALPATE_EXPORT HidBus& systemHidBus();
} // namespace palpate

#endif
