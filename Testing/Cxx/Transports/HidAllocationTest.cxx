// SPDX-License-Identifier: BSD-3-Clause
// read and write of the HID devices do not use the heap, whether connected or not.
#include "AllocationCount.h"
#include "FakeHidBus.h"
#include "Transports/Hid/HidDevice.h"
#include "KnownReports.h"
#include "Transports/Hid/SpaceMouseDevice.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace palpate;
using namespace palpate::testing;

namespace
{
HidEntry entryNumber(std::uint16_t product)
{
  HidEntry entry;
  entry.path = "/dev/hidraw" + std::to_string(product);
  entry.vendor = 0x1209;
  entry.product = product;
  return entry;
}

/// Runs ticks and returns the number of their heap allocations.
long ticks(HapticDevice& device, int count, int& valid)
{
  const long before = allocationCount();
  for (int tick = 0; tick < count; ++tick)
  {
    const DeviceSample sample = device.read(1e-3 * tick);
    valid += sample.valid ? 1 : 0;
    device.write({ 0.0, tick % 97 == 0 ? std::nan("") : 1.0, tick % 7 == 0 ? 100.0 : 0.0 });
    device.errors();
  }
  return allocationCount() - before;
}
} // namespace

TEST(HidAllocation, ForceDevice)
{
  FakeHidBus bus;
  const auto far = std::make_shared<FakeHidDevice>(entryNumber(1));
  bus.plug(far);
  std::string error;
  const auto device = HidDevice::open(far->Entry.path, error, bus);
  ASSERT_TRUE(device) << error;
  int valid = 0;
  EXPECT_EQ(ticks(*device, 1000, valid), 0) << "before its first state";
  EXPECT_EQ(valid, 0);
  StateReport state;
  far->send(state);
  ASSERT_TRUE(eventually([&] { return device->read(0.0).valid; }));
  std::thread sender(
    [&]
    {
      for (int i = 0; i < 200; ++i)
      {
        ++state.sequence;
        state.fault =
          i % 50 == 24; // not in the last state, so that ticks are valid if this thread ends first
        far->send(state);
        std::this_thread::sleep_for(std::chrono::microseconds(500));
      }
    });
  EXPECT_EQ(ticks(*device, 200000, valid), 0);
  sender.join();
  EXPECT_GT(valid, 1000);
  bus.unplug(far->Entry.path);
  ASSERT_TRUE(eventually([&] { return device->errors().disconnections == 1; }));
  valid = 0;
  EXPECT_EQ(ticks(*device, 1000, valid), 0) << "unplugged";
  EXPECT_EQ(valid, 0);
}

TEST(HidAllocation, SpaceMouse)
{
  FakeHidBus bus;
  const auto far = std::make_shared<FakeHidDevice>(entryNumber(2));
  bus.plug(far);
  std::string error;
  const auto mouse = SpaceMouseDevice::open(far->Entry.path, SpaceMouseMode::Rate, error, bus);
  ASSERT_TRUE(mouse) << error;
  const std::uint8_t push[] = { 1, 0x5E, 0x01, 0, 0, 0, 0 };
  far->send(push, sizeof push);
  int valid = 0;
  EXPECT_EQ(ticks(*mouse, 10000, valid), 0);
  EXPECT_EQ(valid, 10000);
}
