// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Access to the devices of the module Transports, libpalpateTransports.so: HID devices and devices
 * driven by other programs. The first call that needs the module loads it. Therefore no function of
 * this file may be called from the servo tick.
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
/// A connected HID device that Palpate can drive.
struct PluggedDevice
{
  std::string address;  ///< "hid:PATH"
  std::string name;     ///< product name; may be empty
  std::string obstacle; ///< reason why the device cannot be opened; "" if it can be opened
};

/// The result of a search for devices.
struct PluggedDevices
{
  std::vector<PluggedDevice> devices; ///< sorted by path
  /// Text with one line per device. A further line gives the reason if no device was found or if
  /// some devices may be missing.
  std::string text;
};

/// Whether `device` is the name of a device that the module opens, "hid:PATH" or "bridge:ADDRESS".
PALPATE_EXPORT bool isTransported(const std::string& device);
/// Opens a device. Returns null if the device cannot be opened or the module is missing, and writes
/// the reason to `error`.
PALPATE_EXPORT std::unique_ptr<HapticDevice> openTransported(
  const std::string& device, std::string& error);
/// Lists the connected devices without opening them. Without the module the list is empty, and
/// `text` contains the reason.
PALPATE_EXPORT PluggedDevices pluggedDevices();
} // namespace palpate

#endif
