// SPDX-License-Identifier: BSD-3-Clause
#include "EmulatedHid.h"

#include <umockdev.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace palpate::testing
{
namespace
{
/// The only testbed of the process, with the thread that answers ioctl calls.
class Testbed
{
public:
  static Testbed& get()
  {
    static Testbed testbed;
    return testbed;
  }

  UMockdevTestbed* operator*() const { return this->Bed; }
  std::string root() const
  {
    gchar* const path = umockdev_testbed_get_root_dir(this->Bed);
    std::string copy = path;
    g_free(path);
    return copy;
  }
  int nextNumber() { return this->Number++; }

private:
  Testbed()
  {
    this->Bed = umockdev_testbed_new();
    chmod(this->root().c_str(),
      0755); // lets other users read the folder, so that only the access to the device is refused
    this->Loop = g_main_loop_new(nullptr, FALSE);
    this->Thread = std::thread([this] { g_main_loop_run(this->Loop); });
  }
  ~Testbed()
  {
    while (!g_main_loop_is_running(this->Loop))
    {
      std::this_thread::yield(); // a loop must have started before it can be stopped
    }
    g_main_loop_quit(this->Loop);
    this->Thread.join();
    g_main_loop_unref(this->Loop);
    g_object_unref(this->Bed);
  }

  UMockdevTestbed* Bed = nullptr;
  GMainLoop* Loop = nullptr;
  std::thread Thread;
  int Number = 0;
};

/// Copies bytes to the argument of an ioctl.
void answer(UMockdevIoctlClient* client, const std::uint8_t* bytes, std::size_t size, long result)
{
  UMockdevIoctlData* const place =
    umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, size, nullptr);
  std::vector<guint8> copy(bytes, bytes + size);
  umockdev_ioctl_data_update(place, 0, copy.data(), static_cast<gint>(size));
  umockdev_ioctl_data_unref(place);
  umockdev_ioctl_client_complete(client, result, 0);
}

/// Answers the two requests of hidapi: size of the report descriptor, and feature report.
gboolean onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer data)
{
  const auto& model = *static_cast<const HidModel*>(data);
  const unsigned long request = umockdev_ioctl_client_get_request(client);
  if (request == HIDIOCGRDESCSIZE)
  {
    const auto size = static_cast<int>(model.reportDescriptor.size());
    std::array<std::uint8_t, sizeof size> bytes{};
    std::copy_n(reinterpret_cast<const std::uint8_t*>(&size), sizeof size, bytes.begin());
    answer(client, bytes.data(), bytes.size(), 0);
    return TRUE;
  }
  if (request == HIDIOCGFEATURE(_IOC_SIZE(request)))
  {
    if (model.feature.empty())
    {
      // A stall, in the form that usbhid reports it.
      umockdev_ioctl_client_complete(client, -1, EPIPE);
      return TRUE;
    }
    std::vector<std::uint8_t> bytes(1, 0); // begins with the number of the report
    bytes.insert(bytes.end(), model.feature.begin(), model.feature.end());
    bytes.resize(std::min<std::size_t>(bytes.size(), _IOC_SIZE(request)));
    answer(client, bytes.data(), bytes.size(), static_cast<long>(bytes.size()));
    return TRUE;
  }
  return FALSE;
}

std::string hexadecimal(const std::vector<std::uint8_t>& bytes)
{
  std::string text;
  for (const std::uint8_t byte : bytes)
  {
    std::array<char, 3> digits{};
    std::snprintf(digits.data(), digits.size(), "%02X", byte);
    text += digits.data();
  }
  return text;
}

std::string fourDigits(int value)
{
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%04X", static_cast<unsigned>(value));
  return text.data();
}

/// Deletes umockdev's note of a pseudo-terminal. umockdev (0.17) keeps such a note for each
/// terminal, which causes an error when the system reuses the terminal.
void forgetTerminal(int far)
{
  std::string note = ptsname(far);
  std::replace(note.begin(), note.end(), '/', '_');
  unlink((Testbed::get().root() + "/dev/.ptymap/" + note).c_str());
}

void add(const std::string& description)
{
  GError* error = nullptr;
  if (!umockdev_testbed_add_from_string(*Testbed::get(), description.c_str(), &error))
  {
    throw std::runtime_error(error->message);
  }
}
} // namespace

EmulatedHid::EmulatedHid(HidModel model)
  : Model(std::move(model))
{
  const int index = Testbed::get().nextNumber();
  const std::string n = std::to_string(index);
  const std::string vendor = fourDigits(this->Model.vendor);
  const std::string product = fourDigits(this->Model.product);
  const std::string usb = "/devices/usb1/1-" + n;
  const std::string interface = usb + "/1-" + n + ":1.0";
  const std::string hidName = "0003:" + vendor + ":" + product + "." + fourDigits(index + 1);
  const std::string hid = interface + "/" + hidName;
  const std::string raw = hid + "/hidraw/hidraw" + n;
  this->Path = "/dev/hidraw" + n;
  add("P: " + usb + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: idVendor=" + vendor +
    "\nA: idProduct=" + product + "\nA: manufacturer=" + this->Model.maker + "\nA: product=" +
    this->Model.name + "\nA: serial=" + this->Model.serial + "\nA: bcdDevice=0100\n");
  add("P: " + interface + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nA: bInterfaceNumber=00\n");
  add("P: " + hid + "\nE: SUBSYSTEM=hid\nE: HID_ID=0003:0000" + vendor + ":0000" + product +
    "\nE: HID_NAME=" + this->Model.maker + " " + this->Model.name +
    "\nE: HID_UNIQ=" + this->Model.serial +
    "\nH: report_descriptor=" + hexadecimal(this->Model.reportDescriptor) + "\n");
  add("P: " + raw + "\nN: hidraw" + n + "\nE: SUBSYSTEM=hidraw\nE: DEVNAME=" + this->Path +
    "\nE: MAJOR=240\nE: MINOR=" + n + "\nA: dev=240:" + n + "\nL: device=../../../" + hidName +
    "\n");
  this->Nodes = { usb, interface, hid, raw };
  if (access(this->Path.c_str(), F_OK) != 0)
  {
    throw std::runtime_error("this program must be run by umockdev-wrapper");
  }

  UMockdevIoctlBase* const handler = umockdev_ioctl_base_new();
  g_signal_connect(handler, "handle-ioctl", G_CALLBACK(onIoctl), &this->Model);
  GError* error = nullptr;
  if (!umockdev_testbed_attach_ioctl(*Testbed::get(), this->Path.c_str(), handler, &error))
  {
    throw std::runtime_error(error->message);
  }
  g_object_unref(handler);
  this->Far = umockdev_testbed_get_dev_fd(*Testbed::get(), this->Path.c_str());
  fcntl(this->Far, F_SETFL, fcntl(this->Far, F_GETFL) | O_NONBLOCK);
}

EmulatedHid::~EmulatedHid()
{
  this->unplug();
}

bool EmulatedHid::send(const std::uint8_t* bytes, std::size_t size)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->flush())
  {
    return false;
  }
  this->Unsent.assign(bytes, bytes + size);
  this->flush();
  if (this->Unsent.size() == size)
  {
    this->Unsent.clear(); // the report does not fit completely and is lost, as in hidraw's buffer
    return false;
  }
  return true;
}

bool EmulatedHid::flush()
{
  if (this->Far >= 0 && !this->Unsent.empty())
  {
    const ssize_t count = write(this->Far, this->Unsent.data(), this->Unsent.size());
    this->Unsent.erase(this->Unsent.begin(), this->Unsent.begin() + std::max<ssize_t>(count, 0));
  }
  return this->Far >= 0 && this->Unsent.empty();
}

bool EmulatedHid::receive(std::vector<std::uint8_t>& report, std::size_t size)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Far < 0)
  {
    return false;
  }
  std::array<std::uint8_t, 4096> bytes{};
  const ssize_t count = read(this->Far, bytes.data(), bytes.size());
  if (count > 0)
  {
    this->Pending.insert(this->Pending.end(), bytes.begin(), bytes.begin() + count);
  }
  if (this->Pending.size() < size + 1)
  {
    return false;
  }
  const auto begin = this->Pending.begin();
  // The report is returned without its number.
  report.assign(begin + 1, begin + 1 + static_cast<std::ptrdiff_t>(size));
  this->Pending.erase(begin, begin + 1 + static_cast<std::ptrdiff_t>(size));
  return true;
}

void EmulatedHid::unplug()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Far < 0)
  {
    return;
  }
  forgetTerminal(this->Far);
  close(this->Far); // reads and writes of the host fail from now on
  this->Far = -1;
  umockdev_testbed_detach_ioctl(*Testbed::get(), this->Path.c_str(), nullptr);
  for (auto node = this->Nodes.rbegin(); node != this->Nodes.rend(); ++node)
  {
    umockdev_testbed_remove_device(*Testbed::get(), ("/sys" + *node).c_str());
  }
}
} // namespace palpate::testing
