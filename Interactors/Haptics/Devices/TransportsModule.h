// SPDX-License-Identifier: BSD-3-Clause
#ifndef TransportsModule_h
#define TransportsModule_h

#include "Haptics/Devices/DeviceTransports.h"
#include "Mechanics/Files/ModuleFile.h"

#include <memory>
#include <string>

namespace palpate
{
/// The functions of libpalpateTransports.so (folder Transports), as described in
/// DeviceTransports.h.
struct TransportsModule : ModuleTable
{
  using Open = std::unique_ptr<HapticDevice> (*)(const std::string& rest, std::string& error);
  Open openHid;    ///< `rest` is the name after "hid:", such as "/dev/hidraw0"
  Open openBridge; ///< `rest` is the name after "bridge:", "unix:/PATH" or "udp:PORT"
  PluggedDevices (*list)();
};
} // namespace palpate

#endif
