// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/DeviceTransports.h"

#include "Haptics/Devices/TransportsModule.h"

namespace palpate
{
namespace
{
/// A kind of device that the module opens: the prefix of its names and the function that opens it.
struct Transport
{
  const char* prefix;
  TransportsModule::Open TransportsModule::*open;
};
constexpr Transport Transports[] = { { "hid:", &TransportsModule::openHid },
  { "bridge:", &TransportsModule::openBridge } };

/// Returns the part of a device's name after the prefix, or "" if the name has another prefix.
std::string addressOf(const std::string& device, const Transport& transport)
{
  const std::string prefix = transport.prefix;
  return device.rfind(prefix, 0) == 0 ? device.substr(prefix.size()) : std::string();
}

/// Returns the module. On failure returns null and sets `fault` to the end of a sentence, "needs "
/// followed by the missing module.
const TransportsModule* transportsModule(std::string& fault)
{
  static const LoadedModule loaded = loadModule("palpateTransports");
  fault = loaded.table ? std::string() : "needs " + missingModule("Transports", loaded.fault);
  return static_cast<const TransportsModule*>(loaded.table);
}
} // namespace

bool isTransported(const std::string& device)
{
  for (const Transport& transport : Transports)
  {
    if (!addressOf(device, transport).empty())
    {
      return true;
    }
  }
  return false;
}

std::unique_ptr<HapticDevice> openTransported(const std::string& device, std::string& error)
{
  for (const Transport& transport : Transports)
  {
    const std::string address = addressOf(device, transport);
    if (!address.empty())
    {
      const TransportsModule* module = transportsModule(error);
      return module ? (module->*transport.open)(address, error) : nullptr;
    }
  }
  error = "is neither \"hid:PATH\" nor \"bridge:ADDRESS\"";
  return nullptr;
}

PluggedDevices pluggedDevices()
{
  std::string fault;
  const TransportsModule* module = transportsModule(fault);
  return module ? module->list() : PluggedDevices{ {}, "A list of devices " + fault + "\n" };
}
} // namespace palpate
