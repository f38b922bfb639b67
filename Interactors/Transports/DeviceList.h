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
  Force,     ///< speaks the 64-byte force reports (HidDevice)
  SpaceMouse ///< a 3Dconnexion mouse with six axes: input only (SpaceMouseDevice)
};
/// "force" or "SpaceMouse".
PALPATE_EXPORT const char* inWords(DeviceKind kind) noexcept;

/// A device that is plugged in and that Palpate can drive.
struct ListedDevice
{
  std::string address; ///< what vtkHapticDevice::Open and `palpate --device` take: "hid:PATH"
  DeviceKind kind = DeviceKind::Force;
  HidEntry entry;       ///< path, maker, name, serial number, ids
  std::string obstacle; ///< in words why it cannot be opened; empty: it can
};

/// The HID devices that are plugged in.
struct PALPATE_EXPORT DeviceList
{
  std::vector<ListedDevice> devices; ///< by path
  /// Why devices may be missing, in words ("built without hidapi"); empty: none are.
  std::string complaint;

  /// One line per device, as printed by `palpate --list-devices`, or one that says that there is
  /// none.
  std::string describe() const;
};

/// Lists the devices that are plugged in, without opening them.
PALPATE_EXPORT DeviceList listDevices(HidBus& bus = systemHidBus());

/// Opens the device at `path` ("/dev/hidraw0") by its kind: a HidDevice or a SpaceMouseDevice (in
/// rate mode). Null, and why in words, if it is neither or cannot be opened.
PALPATE_EXPORT std::unique_ptr<HapticDevice> openHidDevice(
  const std::string& path, std::string& error, HidBus& bus = systemHidBus());

/// Whether Palpate drives such a device, and its kind.
PALPATE_EXPORT bool isKnown(const HidEntry& entry, DeviceKind& kind) noexcept;
/// The entry of the bus for this path; of several usages the one that Palpate drives. Only the path
/// if it is not listed.
PALPATE_EXPORT HidEntry entryAt(HidBus& bus, const std::string& path);
} // namespace palpate

#endif
