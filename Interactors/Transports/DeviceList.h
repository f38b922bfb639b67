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
  SpaceMouse ///< a 3Dconnexion mouse with six axes: input only (SpaceMouseDevice)
};
/// "force" or "SpaceMouse".
PALPATE_EXPORT const char* inWords(DeviceKind kind) noexcept;

/// A device that is plugged in and that Palpate can drive.
struct ListedDevice
{
  std::string address; ///< for vtkHapticDevice::Open and `palpate --device`: "hid:PATH"
  DeviceKind kind = DeviceKind::Force;
  HidEntry entry;       ///< path, maker, name, serial number, ids
  std::string obstacle; ///< the reason why it cannot be opened, in words; empty: it can
};

/// The HID devices that are plugged in.
struct PALPATE_EXPORT DeviceList
{
  std::vector<ListedDevice> devices; ///< by path
  /// The reason why devices may be missing, in words ("built without hidapi"); empty: none are.
  std::string complaint;

  /// One line per device, as printed by `palpate --list-devices`, or a line that says that there is
  /// none.
  std::string describe() const;
};

/// Lists the devices that are plugged in, without opening them.
PALPATE_EXPORT DeviceList listDevices(HidBus& bus = systemHidBus());

/// Opens the device at `path` ("/dev/hidraw0") as its kind requires: a HidDevice or a
/// SpaceMouseDevice (in rate mode). Null, with the reason in words, if it is neither or cannot be
/// opened.
PALPATE_EXPORT std::unique_ptr<HapticDevice> openHidDevice(
  const std::string& path, std::string& error, HidBus& bus = systemHidBus());

/// Whether Palpate drives such a device; sets its kind.
PALPATE_EXPORT bool isKnown(const HidEntry& entry, DeviceKind& kind) noexcept;
/// The entry of the bus for this path; of several usages the one that Palpate drives. If the path
/// is not listed, the entry has only the path.
PALPATE_EXPORT HidEntry entryAt(HidBus& bus, const std::string& path);
} // namespace palpate

#endif
