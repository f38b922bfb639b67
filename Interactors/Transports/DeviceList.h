// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DeviceList_h
#define palpate_DeviceList_h

#include "Haptics/Devices/HapticDevice.h"
#include "Transports/Hid/HidBus.h"
#include "Mechanics/PalpateExport.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
enum class DeviceKind : std::uint8_t
{
  Force,     ///< uses the 64-byte force reports (HidDevice)
  SpaceMouse ///< a 3Dconnexion mouse with six axes and without force output (SpaceMouseDevice)
};
/// Returns the name of the kind, "force" or "SpaceMouse".
PALPATE_EXPORT const char* inWords(DeviceKind kind) noexcept;

/// A connected device that Palpate can drive.
struct ListedDevice
{
  std::string address; ///< "hid:PATH", as for vtkHapticDevice::Open and `palpate --device`
  DeviceKind kind = DeviceKind::Force;
  HidEntry entry;       ///< path, manufacturer, name, serial number and ids
  std::string obstacle; ///< reason why the device cannot be opened; empty if it can be opened
};

/// The connected HID devices.
struct PALPATE_EXPORT DeviceList
{
  std::vector<ListedDevice> devices; ///< sorted by path
  /// The reason why devices may be missing, such as "built without hidapi". Empty if no devices are
  /// missing.
  std::string complaint;

  /// Returns one line per device, as printed by `palpate --list-devices`, or a line that says that
  /// there is no device.
  std::string describe() const;
};

/// Lists the connected devices, without opening them.
PALPATE_EXPORT DeviceList listDevices(HidBus& bus = systemHidBus());

/// Opens the device at `path` ("/dev/hidraw0") as a HidDevice or as a SpaceMouseDevice in rate
/// mode, depending on its kind. If the device is of another kind or cannot be opened, returns null
/// and sets `error` to the reason.
PALPATE_EXPORT std::unique_ptr<HapticDevice> openHidDevice(
  const std::string& path, std::string& error, HidBus& bus = systemHidBus());

/// Whether Palpate can drive the device. Sets `kind` if it can.
PALPATE_EXPORT bool isKnown(const HidEntry& entry, DeviceKind& kind) noexcept;
/// Returns the entry of the bus for this path. If the path has several usages, returns the entry
/// with the usage that Palpate supports. If the path is not listed, the entry contains only the
/// path.
PALPATE_EXPORT HidEntry entryAt(HidBus& bus, const std::string& path);
} // namespace palpate

#endif
