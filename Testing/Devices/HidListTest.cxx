// SPDX-License-Identifier: BSD-3-Clause
// The plugged-in devices that the real hidapi reports, and the reasons why a device cannot be
// opened.
#include "Transports/DeviceList.h"

#include "Firmware.h"

#include <gtest/gtest.h>

#include <memory>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace palpate;
using namespace palpate::testing;

namespace
{
HidModel spaceMouse()
{
  HidModel model;
  model.vendor = 0x256F;
  model.product = 0xC635;
  model.maker = "3Dconnexion";
  model.name = "SpaceMouse Compact";
  model.serial = "";
  // Usage Page (Generic Desktop), Usage (Multi-axis Controller), an empty application collection.
  model.reportDescriptor = { 0x05, 0x01, 0x09, 0x08, 0xA1, 0x01, 0xC0 };
  return model;
}

HidModel keyboard()
{
  HidModel model;
  model.vendor = 0x046D;
  model.product = 0xC31C;
  model.reportDescriptor = { 0x05, 0x01, 0x09, 0x06, 0xA1, 0x01, 0xC0 };
  return model;
}

/// Calls `words` in a process of an unprivileged user. Returns true if the text contains `part`.
/// The process reports this by the exit code 0.
template <class Words>
bool nobodyIsTold(const Words& words, const std::string& part)
{
  const pid_t child = fork();
  if (child == 0)
  {
    const bool changed = getuid() != 0 || setuid(65534) == 0;
    const std::string said = words();
    _exit(changed && said.find(part) != std::string::npos ? 0 : 1);
  }
  int status = 1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}
} // namespace

TEST(HidList, NamesWhatIsPluggedIn)
{
  EXPECT_TRUE(listDevices().devices.empty());
  const EmulatedHid mouse(spaceMouse());
  const EmulatedHid keys(keyboard());
  const EmulatedHid force(modelOf(describedDevice()));
  const DeviceList list = listDevices();
  ASSERT_EQ(list.devices.size(), 2U);
  EXPECT_EQ(list.complaint, "");

  EXPECT_EQ(list.devices[0].kind, DeviceKind::SpaceMouse);
  EXPECT_EQ(list.devices[0].address, "hid:" + mouse.path());
  EXPECT_EQ(list.devices[0].entry.maker, "3Dconnexion");
  EXPECT_EQ(list.devices[0].entry.name, "SpaceMouse Compact");

  const ListedDevice& device = list.devices[1];
  EXPECT_EQ(device.kind, DeviceKind::Force);
  EXPECT_EQ(device.entry.path, force.path());
  EXPECT_EQ(device.entry.vendor, 0x1209);
  EXPECT_EQ(device.entry.product, 0x0001);
  EXPECT_EQ(device.entry.usagePage, 0xFF00) << "palpate_hid_report_descriptor";
  EXPECT_EQ(device.entry.usage, 0x50);
  EXPECT_EQ(device.entry.maker, "Somebody");
  EXPECT_EQ(device.entry.name, "Palpate test device");
  EXPECT_EQ(device.entry.serial, "42");
  EXPECT_EQ(device.obstacle, "");
  EXPECT_NE(list.describe().find("Somebody Palpate test device  serial 42"), std::string::npos);

  std::string error;
  EXPECT_FALSE(openHidDevice(keys.path(), error));
  EXPECT_NE(error.find("neither a force device"), std::string::npos) << error;
  EXPECT_TRUE(openHidDevice(force.path(), error)) << error;
  EXPECT_TRUE(openHidDevice(mouse.path(), error)) << error;
}

TEST(HidList, WhatIsGoneIsNotListed)
{
  EmulatedHid force(modelOf(describedDevice()));
  ASSERT_EQ(listDevices().devices.size(), 1U);
  force.unplug();
  EXPECT_TRUE(listDevices().devices.empty());
  std::string error;
  EXPECT_FALSE(openHidDevice(force.path(), error));
  EXPECT_NE(error.find(force.path()), std::string::npos) << error;
}

TEST(HidList, WithoutPermissionTheUdevRuleIsNamed)
{
  const EmulatedHid force(modelOf(describedDevice()));
  ASSERT_EQ(chmod(force.path().c_str(), 0), 0);
  const auto obstacle = [&force] { return systemHidBus().obstacle(force.path()); };
  EXPECT_TRUE(nobodyIsTold(obstacle, "70-palpate.rules"));
  const auto opened = [&force]
  {
    std::string error;
    return systemHidBus().open(force.path(), error) ? std::string() : error;
  };
  EXPECT_TRUE(nobodyIsTold(opened, "70-palpate.rules"));
}
