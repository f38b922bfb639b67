// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Devices of the module Transports, libpalpateTransports.so: HID devices and other programs. The
 * first call that needs the module loads it; do not call it from the servo tick.
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
  std::string obstacle; ///< the reason why it cannot be opened, in words; empty: it can
};

/// The result of a search for devices.
struct PluggedDevices
{
  std::vector<PluggedDevice> devices; ///< by path
  /// One line per device, and a line with the reason if there is none or if some may be missing.
  std::string text;
};

/// Whether `device` names a device that the module opens: "hid:PATH", "bridge:ADDRESS".
PALPATE_EXPORT bool isTransported(const std::string& device);
/// Opens a device. Null, with the reason in words, if it cannot be opened or the module is missing.
PALPATE_EXPORT std::unique_ptr<HapticDevice> openTransported(
  const std::string& device, std::string& error);
/// The devices that are plugged in; does not open them. Without the module the list is empty, and
/// `text` gives the reason.
PALPATE_EXPORT PluggedDevices pluggedDevices();
} // namespace palpate

#endif
