// SPDX-License-Identifier: BSD-3-Clause
// The HID devices of the system. Only this file uses hidapi.
#include "Transports/Hid/HidBus.h"

#include <hidapi.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <mutex>

#include <unistd.h>

namespace palpate
{
namespace
{
/// Returns the mutex for those calls of hidapi that use no device. hidapi has one error text for
/// all of these calls, and each call frees this text.
std::mutex& oneAtATime()
{
  static std::mutex mutex;
  return mutex;
}

/// Converts a text of hidapi to UTF-8, regardless of the program's locale.
std::string narrow(const wchar_t* text)
{
  std::string bytes;
  for (; text != nullptr && *text != L'\0'; ++text)
  {
    const auto code = static_cast<std::uint32_t>(*text & 0x1FFFFF);
    const auto tail = [code](int shift)
    { return static_cast<char>(0x80U | ((code >> shift) & 0x3FU)); };
    if (code < 0x80)
    {
      bytes += static_cast<char>(code);
    }
    else if (code < 0x800)
    {
      bytes += { static_cast<char>(0xC0U | (code >> 6)), tail(0) };
    }
    else if (code < 0x10000)
    {
      bytes += { static_cast<char>(0xE0U | (code >> 12)), tail(6), tail(0) };
    }
    else
    {
      bytes += { static_cast<char>(0xF0U | ((code >> 18) & 7U)), tail(12), tail(6), tail(0) };
    }
  }
  return bytes;
}

class HidapiPort final : public HidPort
{
public:
  explicit HidapiPort(hid_device* device)
    : Device(device)
  {
  }
  ~HidapiPort() override { hid_close(this->Device); }
  HidapiPort(const HidapiPort&) = delete;
  HidapiPort& operator=(const HidapiPort&) = delete;

  int read(std::uint8_t* bytes, std::size_t size, int milliseconds) noexcept override
  {
    errno = 0;
    const int count = hid_read_timeout(this->Device, bytes, size, milliseconds);
    // An interruption by a signal does not mean that the device is unplugged.
    return count < 0 && errno == EINTR ? 0 : count;
  }

  bool write(const std::uint8_t* bytes, std::size_t size) noexcept override
  {
    if (size >= this->Numbered.size())
    {
      return false;
    }
    this->Numbered[0] = 0; // report number 0 means an unnumbered report
    std::copy_n(bytes, size, this->Numbered.begin() + 1);
    return hid_write(this->Device, this->Numbered.data(), size + 1) == static_cast<int>(size) + 1;
  }

  int feature(std::uint8_t* bytes, std::size_t size) noexcept override
  {
    if (size >= this->Numbered.size())
    {
      return -1;
    }
    this->Numbered.fill(0);
    const int count = hid_get_feature_report(this->Device, this->Numbered.data(), size + 1) - 1;
    if (count < 0 || static_cast<std::size_t>(count) > size)
    {
      return -1;
    }
    std::copy_n(this->Numbered.begin() + 1, count, bytes);
    return count;
  }

private:
  hid_device* Device;
  std::array<std::uint8_t, 256> Numbered{};
};

class HidapiBus final : public HidBus
{
public:
  std::vector<HidEntry> entries() override
  {
    const std::lock_guard<std::mutex> lock(oneAtATime());
    hid_device_info* const first = hid_enumerate(0, 0);
    std::vector<HidEntry> entries;
    for (const hid_device_info* info = first; info != nullptr; info = info->next)
    {
      HidEntry entry;
      entry.path = info->path != nullptr ? info->path : "";
      entry.vendor = info->vendor_id;
      entry.product = info->product_id;
      entry.usagePage = info->usage_page;
      entry.usage = info->usage;
      entry.maker = narrow(info->manufacturer_string);
      entry.name = narrow(info->product_string);
      entry.serial = narrow(info->serial_number);
      entries.push_back(std::move(entry));
    }
    hid_free_enumeration(first);
    return entries;
  }

  std::unique_ptr<HidPort> open(const std::string& path, std::string& error) override
  {
    error = this->obstacle(path);
    if (!error.empty())
    {
      return nullptr;
    }
    const std::lock_guard<std::mutex> lock(oneAtATime());
    hid_device* const device = hid_open_path(path.c_str());
    if (device == nullptr)
    {
      error = narrow(hid_error(nullptr));
      return nullptr;
    }
    return std::make_unique<HidapiPort>(device);
  }

  std::string obstacle(const std::string& path) override
  {
    if (access(path.c_str(), R_OK | W_OK) == 0)
    {
      return {};
    }
    const int reason = errno;
    if (reason == EACCES || reason == EPERM)
    {
      return "no permission to read and write " + path +
        ": install the udev rule 70-palpate.rules (in lib/udev/rules.d of an installation, see "
        "its head), then plug the device in again";
    }
    if (reason == ENOENT)
    {
      return "there is no " + path;
    }
    return path + ": " + std::strerror(reason);
  }
};
} // namespace

HidBus& systemHidBus()
{
  static HidapiBus bus;
  return bus;
}
} // namespace palpate
