// SPDX-License-Identifier: BSD-3-Clause
#include "Transports/DeviceList.h"

#include "Transports/Hid/HidDevice.h"
#include "Transports/Hid/SpaceMouseDevice.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr std::uint16_t ForceUsagePage = 0xFF00;
constexpr std::uint16_t ForceUsage = 0x50;

constexpr std::uint16_t Logitech = 0x046D; ///< vendor number of older 3Dconnexion devices
constexpr std::uint16_t Connexion = 0x256F;
constexpr std::uint16_t GenericDesktopPage = 0x01;
constexpr std::uint16_t MultiAxisController = 0x08;

/// Both manufacturers also have other products. Their devices with six axes have the usage of a
/// multi-axis controller and product numbers 0xC6xx.
bool isSpaceMouse(const HidEntry& entry) noexcept
{
  const bool axes = (entry.usagePage == GenericDesktopPage && entry.usage == MultiAxisController) ||
    entry.usagePage == 0; // the usage is unknown
  return axes && (entry.vendor == Logitech || entry.vendor == Connexion) &&
    (entry.product & 0xFF00U) == 0xC600U;
}

std::string identifiers(const HidEntry& entry)
{
  std::array<char, 10> text{};
  std::snprintf(text.data(), text.size(), "%04x:%04x", static_cast<unsigned>(entry.vendor),
    static_cast<unsigned>(entry.product));
  return text.data();
}
} // namespace

const char* inWords(DeviceKind kind) noexcept
{
  return kind == DeviceKind::Force ? "force" : "SpaceMouse";
}

bool isKnown(const HidEntry& entry, DeviceKind& kind) noexcept
{
  if (entry.usagePage == ForceUsagePage && entry.usage == ForceUsage)
  {
    kind = DeviceKind::Force;
    return true;
  }
  kind = DeviceKind::SpaceMouse;
  return isSpaceMouse(entry);
}

HidEntry entryAt(HidBus& bus, const std::string& path)
{
  HidEntry found;
  found.path = path;
  bool known = false;
  for (HidEntry& entry : bus.entries())
  {
    if (entry.path == path && !known)
    {
      DeviceKind kind{};
      known = isKnown(entry, kind);
      found = std::move(entry);
    }
  }
  return found;
}

DeviceList listDevices(HidBus& bus)
{
  DeviceList list;
  list.complaint = bus.complaint();
  for (HidEntry& entry : bus.entries())
  {
    ListedDevice device;
    const bool listed = std::any_of(list.devices.begin(), list.devices.end(),
      [&entry](const ListedDevice& other) { return other.entry.path == entry.path; });
    // A device has one entry for each usage but is listed once.
    if (!listed && isKnown(entry, device.kind))
    {
      device.address = "hid:" + entry.path;
      device.obstacle = bus.obstacle(entry.path);
      device.entry = std::move(entry);
      list.devices.push_back(std::move(device));
    }
  }
  std::sort(list.devices.begin(), list.devices.end(),
    [](const ListedDevice& a, const ListedDevice& b) { return a.entry.path < b.entry.path; });
  return list;
}

std::string DeviceList::describe() const
{
  std::string text;
  for (const ListedDevice& device : this->devices)
  {
    const HidEntry& entry = device.entry;
    text += device.address + "  " + inWords(device.kind) + "  " + identifiers(entry) + "  " +
      entry.maker + (entry.maker.empty() ? "" : " ") + entry.name;
    text += entry.serial.empty() ? "" : "  serial " + entry.serial;
    text += device.obstacle.empty() ? "\n" : "\n  " + device.obstacle + "\n";
  }
  if (!this->complaint.empty())
  {
    text += this->complaint + "\n";
  }
  else if (this->devices.empty())
  {
    text += "no HID device that Palpate can drive is plugged in\n";
  }
  return text;
}

std::unique_ptr<HapticDevice> openHidDevice(
  const std::string& path, std::string& error, HidBus& bus)
{
  error = bus.complaint();
  if (!error.empty())
  {
    return nullptr;
  }
  const HidEntry entry = entryAt(bus, path);
  DeviceKind kind{};
  if (isKnown(entry, kind))
  {
    if (kind == DeviceKind::Force)
    {
      return HidDevice::open(path, error, bus);
    }
    return SpaceMouseDevice::open(path, SpaceMouseMode::Rate, error, bus);
  }
  if (entry.vendor != 0)
  {
    error = path + " (" + identifiers(entry) + " " + entry.name +
      ") is neither a force device (vendor page 0xFF00, usage 0x50) nor a SpaceMouse";
    return nullptr;
  }
  error = bus.obstacle(path);
  if (error.empty())
  {
    error = path + " is not among the HID devices of this system";
  }
  return nullptr;
}
} // namespace palpate
