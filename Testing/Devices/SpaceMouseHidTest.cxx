// SPDX-License-Identifier: BSD-3-Clause
// A SpaceMouse through the real hidapi, with the report layout of the classic and of the wireless
// models.
#include "Transports/Hid/SpaceMouseDevice.h"

#include "EmulatedHid.h"
#include "FakeHidBus.h"

#include <gtest/gtest.h>

#include <memory>

using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
HidModel model()
{
  HidModel model;
  model.vendor = 0x046D;
  model.product = 0xC626;
  model.maker = "3Dconnexion";
  model.name = "SpaceNavigator";
  model.serial = "";
  model.reportDescriptor = { 0x05, 0x01, 0x09, 0x08, 0xA1, 0x01, 0xC0 };
  return model;
}

/// Sends a report, then a button, and waits until a tick reads the button. `buttons` must differ
/// from those of the previous call.
bool push(EmulatedHid& hid, SpaceMouseDevice& mouse, const std::vector<std::uint8_t>& report,
  std::uint8_t buttons)
{
  hid.send(report.data(), report.size());
  // Such a device sends a report every 8 ms. The emulated device is a stream of bytes. Therefore
  // the first report must be read before the second is sent, even on a busy machine.
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  const std::uint8_t pressed[] = { 3, buttons, 0 };
  hid.send(pressed, sizeof pressed);
  return eventually([&] { return mouse.read(0.0).buttons == buttons; });
}

DeviceSample afterSeconds(SpaceMouseDevice& mouse, double seconds)
{
  DeviceSample sample;
  for (int i = 0; i <= static_cast<int>(1000.0 * seconds); ++i)
  {
    sample = mouse.read(1e-3 * i);
  }
  return sample;
}
} // namespace

TEST(SpaceMouseHid, ClassicAndWirelessReports)
{
  EmulatedHid hid(model());
  std::string error;
  const auto mouse = SpaceMouseDevice::open(hid.path(), SpaceMouseMode::Position, error);
  ASSERT_TRUE(mouse) << error;
  EXPECT_TRUE(mouse->read(0.0).valid) << "silent at rest";
  ASSERT_TRUE(push(hid, *mouse, { 1, 0x5E, 0x01, 0, 0, 0, 0 }, 1));
  EXPECT_LT((afterSeconds(*mouse, 2.0).position - Vector3d(0.05, 0.0, 0.0)).norm(), 1e-9);
  ASSERT_TRUE(push(hid, *mouse, { 1, 0, 0, 0x5E, 0x01, 0, 0, 0, 0, 0, 0, 0, 0 }, 2));
  EXPECT_LT((afterSeconds(*mouse, 2.0).position - Vector3d(0.0, 0.0, 0.05)).norm(), 1e-9);
  EXPECT_EQ(mouse->errors().malformed, 0U);
}

TEST(SpaceMouseHid, UnpluggedAndBack)
{
  auto hid = std::make_unique<EmulatedHid>(model());
  std::string error;
  const auto mouse = SpaceMouseDevice::open(hid->path(), SpaceMouseMode::Rate, error);
  ASSERT_TRUE(mouse) << error;
  hid.reset();
  ASSERT_TRUE(eventually([&] { return !mouse->read(0.0).valid; }));
  ASSERT_TRUE(eventually([&] { return mouse->errors().disconnections == 1; }));
  EXPECT_TRUE(eventually([&] { return mouse->status() == "unplugged, waiting for it to return"; }));
  hid = std::make_unique<EmulatedHid>(model());
  ASSERT_TRUE(eventually([&] { return mouse->read(0.0).valid; }));
  EXPECT_TRUE(push(*hid, *mouse, { 1, 0x5E, 0x01, 0, 0, 0, 0 }, 1));
}
