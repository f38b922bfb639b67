// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Devices of the module Transports, libpalpateTransports.so: HID devices and other programs. The
 * first call that needs the module loads it; therefore no function may be called from the servo
 * tick.
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
  std::string name;     ///< name of the product; may be empty
  std::string obstacle; ///< the reason why the device cannot be opened; "": it can be opened
};

/// The result of a search for devices.
struct PluggedDevices
{
  std::vector<PluggedDevice> devices; ///< sorted by path
  /// One line per device, and a line with the reason if there is no device or some may be missing.
  std::string text;
};

/// Whether `device` names a device that the module opens: "hid:PATH", "bridge:ADDRESS".
PALPATE_EXPORT bool isTransported(const std::string& device);
/// Opens a device. Returns null, with the reason in words, if the device cannot be opened or the
/// module is missing.
PALPATE_EXPORT std::unique_ptr<HapticDevice> openTransported(
  const std::string& device, std::string& error);
/// Lists the connected devices without opening them. Without the module the list is empty, and
/// `text` contains the reason.
PALPATE_EXPORT PluggedDevices pluggedDevices();
} // namespace palpate

#endif
