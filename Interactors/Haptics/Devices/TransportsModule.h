// SPDX-License-Identifier: BSD-3-Clause
#ifndef TransportsModule_h
#define TransportsModule_h

#include "Haptics/Devices/DeviceTransports.h"
#include "Mechanics/Files/ModuleFile.h"

#include <memory>
#include <string>

namespace palpate
{
/// The functions of libpalpateTransports.so (room Transports): see DeviceTransports.h.
struct TransportsModule : ModuleTable
{
  using Open = std::unique_ptr<HapticDevice> (*)(const std::string& rest, std::string& error);
  Open openHid;    ///< `rest` of the name: "/dev/hidraw0"
  Open openBridge; ///< "unix:/PATH", "udp:PORT"
  PluggedDevices (*list)();
};
} // namespace palpate

#endif
