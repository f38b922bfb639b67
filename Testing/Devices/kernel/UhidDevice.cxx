// SPDX-License-Identifier: BSD-3-Clause
#include "UhidDevice.h"

#include <fcntl.h>
#include <linux/uhid.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace palpate::testing
{
namespace
{
[[noreturn]] void fail(const std::string& what)
{
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

bool give(int file, const uhid_event& event)
{
  return write(file, &event, sizeof event) == static_cast<ssize_t>(sizeof event);
}

/// Copies a text to a field. The field is given as a pointer, because a reference to a packed field
/// is not allowed.
void put(__u8* field, std::size_t size, const std::string& text)
{
  std::memcpy(field, text.c_str(), std::min(size - 1, text.size()));
}

/// Returns "/dev/hidrawN" of the device with this HID_PHYS, or "".
std::string nodeOf(const std::string& phys)
{
  std::error_code none;
  for (const auto& node : std::filesystem::directory_iterator("/sys/class/hidraw", none))
  {
    std::ifstream file(node.path() / "device/uevent");
    for (std::string line; std::getline(file, line);)
    {
      if (line == "HID_PHYS=" + phys)
      {
        return "/dev/" + node.path().filename().string();
      }
    }
  }
  return {};
}
} // namespace

UhidDevice::UhidDevice(const HidModel& model)
  : Feature(model.feature)
{
  static std::atomic<int> made{ 0 };
  const std::string phys = "palpate/" + std::to_string(++made);
  this->create(model, phys);
  this->Plugged = true;
  this->Thread = std::thread([this] { this->serve(); });
  for (int i = 0; i < 5000 && this->Path.empty(); ++i)
  {
    const std::string node = nodeOf(phys);
    if (!node.empty() && access(node.c_str(), R_OK | W_OK) == 0)
    {
      this->Path = node;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (this->Path.empty())
  {
    this->Stopping = true;
    this->Thread.join();
    close(this->File);
    throw std::runtime_error("no hidraw for " + phys);
  }
}

UhidDevice::~UhidDevice()
{
  this->unplug();
  this->Stopping = true;
  this->Thread.join();
  close(this->File);
}

void UhidDevice::create(const HidModel& model, const std::string& phys)
{
  this->File = open("/dev/uhid", O_RDWR | O_CLOEXEC | O_NONBLOCK);
  if (this->File < 0)
  {
    fail("/dev/uhid");
  }
  uhid_event event{};
  event.type = UHID_CREATE2;
  put(event.u.create2.name, sizeof event.u.create2.name, model.name);
  put(event.u.create2.phys, sizeof event.u.create2.phys, phys);
  put(event.u.create2.uniq, sizeof event.u.create2.uniq, model.serial);
  event.u.create2.bus = BUS_USB;
  event.u.create2.vendor = model.vendor;
  event.u.create2.product = model.product;
  event.u.create2.rd_size = static_cast<__u16>(model.reportDescriptor.size());
  std::copy(model.reportDescriptor.begin(), model.reportDescriptor.end(), event.u.create2.rd_data);
  if (!give(this->File, event))
  {
    close(this->File);
    fail("UHID_CREATE2");
  }
}

void UhidDevice::serve()
{
  while (!this->Stopping)
  {
    pollfd ready{ this->File, POLLIN, 0 };
    uhid_event event{};
    if (poll(&ready, 1, 20) <= 0 || read(this->File, &event, sizeof event) <= 0)
    {
      continue;
    }
    if (event.type == UHID_GET_REPORT)
    {
      this->answerFeature(event.u.get_report.id);
    }
    else if (event.type == UHID_OUTPUT && event.u.output.size > 0)
    {
      const __u8* data = event.u.output.data; // begins with the number of the report
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Reports.emplace_back(data + 1, data + event.u.output.size);
    }
  }
}

void UhidDevice::answerFeature(std::uint32_t id)
{
  uhid_event answer{};
  answer.type = UHID_GET_REPORT_REPLY;
  answer.u.get_report_reply.id = id;
  if (this->Feature.empty())
  {
    answer.u.get_report_reply.err = EIO;
  }
  else
  {
    answer.u.get_report_reply.size = static_cast<__u16>(this->Feature.size() + 1);
    std::copy(this->Feature.begin(), this->Feature.end(), answer.u.get_report_reply.data + 1);
  }
  give(this->File, answer);
}

bool UhidDevice::send(const std::uint8_t* bytes, std::size_t size)
{
  uhid_event event{};
  event.type = UHID_INPUT2;
  event.u.input2.size = static_cast<__u16>(size);
  std::copy(bytes, bytes + size, event.u.input2.data);
  return this->Plugged && give(this->File, event);
}

bool UhidDevice::receive(std::vector<std::uint8_t>& report)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Reports.empty())
  {
    return false;
  }
  report = std::move(this->Reports.front());
  this->Reports.pop_front();
  return true;
}

void UhidDevice::unplug()
{
  if (this->Plugged.exchange(false))
  {
    uhid_event event{};
    event.type = UHID_DESTROY;
    give(this->File, event);
  }
}
} // namespace palpate::testing
