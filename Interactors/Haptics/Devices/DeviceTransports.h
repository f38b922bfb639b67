// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Devices that are reached through the module Transports, libpalpateTransports.so: HID devices and
 * other programs. The first call that needs the module loads it; not from the servo tick.
 */
#ifndef palpate_DeviceTransports_h
#define palpate_DeviceTransports_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// A HID device that is plugged in and that Palpate can drive.
struct PluggedDevice
{
  std::string address;  ///< "hid:PATH"
  std::string name;     ///< of the product; may be empty
  std::string obstacle; ///< in words why it cannot be opened; empty: it can
};

/// What a search for devices found.
struct PluggedDevices
{
  std::vector<PluggedDevice> devices; ///< by path
  /// One line per device, and one that says why there is none or why some may be missing.
  std::string text;
};

/// Whether it is the name of a device that the module opens: "hid:PATH", "bridge:ADDRESS".
PALPATE_EXPORT bool isTransported(const std::string& device);
/// Opens it. Null, and why in words, if it cannot be opened or the module is missing.
PALPATE_EXPORT std::unique_ptr<HapticDevice> openTransported(
  const std::string& device, std::string& error);
/// The devices that are plugged in, without opening them. Without the module none, and `text` says
/// so.
PALPATE_EXPORT PluggedDevices pluggedDevices();
} // namespace palpate

#endif
