// SPDX-License-Identifier: BSD-3-Clause
// The content and the text of `palpate --list-devices`.
#include "Transports/DeviceList.h"

#include "FakeHidBus.h"

#include <gtest/gtest.h>

using namespace palpate;
using namespace palpate::testing;

namespace
{
std::shared_ptr<FakeHidDevice> made(const std::string& path, std::uint16_t vendor,
  std::uint16_t product, std::uint16_t usagePage, std::uint16_t usage)
{
  HidEntry entry;
  entry.path = path;
  entry.vendor = vendor;
  entry.product = product;
  entry.usagePage = usagePage;
  entry.usage = usage;
  entry.maker = "Maker";
  entry.name = "Product";
  return std::make_shared<FakeHidDevice>(entry);
}

void plugOneOfEach(FakeHidBus& bus)
{
  bus.plug(made("/dev/hidraw4", 0x256F, 0xC652, 1, 2)); // a receiver: a mouse, and
  bus.plug(made("/dev/hidraw4", 0x256F, 0xC652, 1, 8)); // six axes on the same path
  bus.plug(made("/dev/hidraw4", 0x256F, 0xC652, 0, 0));
  bus.plug(made("/dev/hidraw0", 0x1209, 0x0001, 0xFF00, 0x50));
  bus.plug(made("/dev/hidraw1", 0x046D, 0xC31C, 1, 6));      // a keyboard
  bus.plug(made("/dev/hidraw2", 0x046D, 0xC626, 1, 8));      // an older SpaceNavigator
  bus.plug(made("/dev/hidraw3", 0x046D, 0xC077, 1, 2));      // a mouse
  bus.plug(made("/dev/hidraw5", 0x1209, 0x0001, 0xFF00, 1)); // a vendor-defined device
}
} // namespace

TEST(DeviceList, NamesWhatPalpateDrivesAndNothingElse)
{
  FakeHidBus bus;
  plugOneOfEach(bus);
  const DeviceList list = listDevices(bus);
  ASSERT_EQ(list.devices.size(), 3U);
  EXPECT_EQ(list.devices[0].address, "hid:/dev/hidraw0");
  EXPECT_EQ(list.devices[0].kind, DeviceKind::Force);
  EXPECT_EQ(list.devices[1].address, "hid:/dev/hidraw2");
  EXPECT_EQ(list.devices[1].kind, DeviceKind::SpaceMouse);
  EXPECT_EQ(list.devices[2].address, "hid:/dev/hidraw4");
  EXPECT_EQ(list.devices[2].kind, DeviceKind::SpaceMouse);
  EXPECT_EQ(list.complaint, "");
}

TEST(DeviceList, SaysItInLines)
{
  FakeHidBus bus;
  EXPECT_EQ(listDevices(bus).describe(), "no HID device that Palpate can drive is plugged in\n");
  bus.plug(made("/dev/hidraw0", 0x1209, 0x0001, 0xFF00, 0x50));
  EXPECT_EQ(listDevices(bus).describe(), "hid:/dev/hidraw0  force  1209:0001  Maker Product\n");
  bus.setObstacle("/dev/hidraw0", "no permission");
  EXPECT_EQ(listDevices(bus).describe(),
    "hid:/dev/hidraw0  force  1209:0001  Maker Product\n  no permission\n");
}

TEST(DeviceList, OpensEachAsWhatItIs)
{
  FakeHidBus bus;
  plugOneOfEach(bus);
  std::string error;
  const auto force = openHidDevice("/dev/hidraw0", error, bus);
  ASSERT_TRUE(force) << error;
  EXPECT_TRUE(force->specification().outputsForce);
  const auto mouse = openHidDevice("/dev/hidraw4", error, bus);
  ASSERT_TRUE(mouse) << error;
  EXPECT_FALSE(mouse->specification().outputsForce);
  EXPECT_FALSE(openHidDevice("/dev/hidraw1", error, bus));
  EXPECT_NE(error.find("neither a force device"), std::string::npos) << error;
  EXPECT_NE(error.find("046d:c31c"), std::string::npos) << error;
  EXPECT_FALSE(openHidDevice("/dev/hidraw9", error, bus));
  EXPECT_NE(error.find("/dev/hidraw9"), std::string::npos) << error;
}

TEST(DeviceList, TheSystemsOwnIsListedWithoutHarm)
{
  const DeviceList list = listDevices();
  EXPECT_FALSE(list.describe().empty());
  std::string error;
  EXPECT_FALSE(openHidDevice("/dev/there-is-no-such-device", error));
  EXPECT_FALSE(error.empty());
}
