// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/TransportsModule.h"

#include "Transports/Bridge/BridgeDevice.h"
#include "Transports/DeviceList.h"

namespace palpate
{
namespace
{
std::unique_ptr<HapticDevice> openHid(const std::string& path, std::string& error)
{
  return openHidDevice(path, error);
}

std::unique_ptr<HapticDevice> openBridge(const std::string& address, std::string& error)
{
  return BridgeDevice::open(address, error);
}

PluggedDevices list()
{
  const DeviceList found = listDevices();
  PluggedDevices plugged{ {}, found.describe() };
  for (const ListedDevice& device : found.devices)
  {
    plugged.devices.push_back({ device.address, device.entry.name, device.obstacle });
  }
  return plugged;
}

constexpr TransportsModule Module{ { PALPATE_VERSION }, openHid, openBridge, list };
} // namespace
} // namespace palpate

extern "C" PALPATE_EXPORT const palpate::ModuleTable* palpateTransportsModule()
{
  return &palpate::Module;
}
