// SPDX-License-Identifier: BSD-3-Clause
// The device is unplugged while the tool presses. The first tick after the device has reported its
// loss never sends a force. Afterwards the device is plugged in again.
#include "Transports/Hid/HidDevice.h"

#include "FakeHidBus.h"
#include "Firmware.h"
#include "PressingServo.h"
#include "PulledPlug.h"
#include "SampleResponses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <random>
#include <thread>
#include <vector>

using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;
using Clock = std::chrono::steady_clock;

namespace
{
void print(const char* what, std::vector<double> milliseconds)
{
  std::sort(milliseconds.begin(), milliseconds.end());
  std::printf("%s: median %.2f ms, worst %.2f ms of %zu\n", what,
    milliseconds[milliseconds.size() / 2], milliseconds.back(), milliseconds.size());
}
/// Returns true if another round is needed: until the planned number is reached, and longer if
/// fewer than half of the rounds began during contact, as on a busy machine.
bool goOn(int round, int planned, int pressing)
{
  return round < planned || (pressing <= planned / 2 && round < 10 * planned);
}
} // namespace

// The device is unplugged during a press. The program palpateUnplugs does so at random times and
// more often.
TEST(HidUnplug, NoForceInTheFirstTickAfterTheLossEveryTime)
{
  constexpr int Rounds = 100;
  const std::shared_ptr<const ContactBody> plate = uniformBody(openPlate(10.0, 20));
  std::mt19937 random(4711);
  std::uniform_int_distribution<int> wait(0, 3000); // µs
  std::vector<double> wall;
  int pressing = 0;
  for (int round = 0; goOn(round, Rounds, pressing); ++round)
  {
    const PulledPlug pulled = pullPlug(plate, { 0.0, std::chrono::microseconds(wait(random)) });
    ASSERT_EQ(pulled.fault, "") << "round " << round;
    pressing += pulled.motors > 0.0 ? 1 : 0;
    wall.push_back(pulled.wall);
  }
  EXPECT_GT(pressing, Rounds / 2) << "many were pulled in mid-contact";
  print("from the plug to the first tick without force", wall);
}

TEST(HidUnplug, ItReturnsAndIsFeltAgain)
{
  constexpr int Rounds = 8;
  const std::shared_ptr<const ContactBody> plate = uniformBody(openPlate(10.0, 20));
  auto hid = std::make_unique<EmulatedHid>(modelOf(describedDevice()));
  std::string error;
  const auto device = HidDevice::open(hid->path(), error);
  ASSERT_TRUE(device) << error;
  auto firmware = std::make_unique<Firmware>(*hid, press);
  PressingServo servo(*device, plate);
  std::vector<double> wall;
  for (int round = 0; round < Rounds; ++round)
  {
    ASSERT_TRUE(servo.ticksUntilForce()) << device->status();
    hid->unplug();
    while (!servo.tick())
    {
    }
    ASSERT_EQ(servo.force(), Vector3d::Zero());
    servo.forgetLosses();
    firmware.reset();
    hid = std::make_unique<EmulatedHid>(modelOf(describedDevice())); // gets a different path
    const auto plugged = Clock::now();
    firmware = std::make_unique<Firmware>(*hid, press);
    for (int i = 0; i < PatientTicks && device->status() != "connected"; ++i)
    {
      servo.tick();
    }
    wall.push_back(std::chrono::duration<double, std::milli>(Clock::now() - plugged).count());
    EXPECT_EQ(device->status(), "connected");
  }
  EXPECT_TRUE(servo.ticksUntilForce()) << device->status();
  EXPECT_EQ(device->errors().disconnections, static_cast<std::uint64_t>(Rounds));
  print("from the plug's return to a connected device", wall);
}

TEST(HidUnplug, ASilentDeviceIsLetGoInTheFirstTickAfterItsTimeOut)
{
  constexpr int Rounds = 20;
  const std::shared_ptr<const ContactBody> plate = uniformBody(openPlate(10.0, 20));
  EmulatedHid hid(modelOf(describedDevice()));
  std::string error;
  const auto device = HidDevice::open(hid.path(), error);
  ASSERT_TRUE(device) << error;
  const double timeOut = device->specification().sampleTimeOut;
  Firmware firmware(hid, press);
  PressingServo servo(*device, plate);
  int pressing = 0;
  for (int round = 0; goOn(round, Rounds, pressing); ++round)
  {
    ASSERT_TRUE(servo.ticksUntilForce()) << device->status();
    firmware.hang(true);
    bool wasPressing = false;
    int ticks = 0;
    while (servo.silence() <= timeOut)
    {
      wasPressing = servo.force().norm() > 0.0;
      servo.tick();
      ASSERT_LT(++ticks, PatientTicks) << "readings go on";
    }
    ASSERT_EQ(servo.force(), Vector3d::Zero()) << "round " << round;
    pressing += wasPressing ? 1 : 0;
    for (int i = 0; i < 20; ++i)
    {
      servo.tick();
      ASSERT_EQ(servo.force(), Vector3d::Zero()) << "round " << round << ", tick " << i;
    }
    firmware.hang(false);
  }
  EXPECT_GT(pressing, Rounds / 2) << "many fell silent in mid-contact";
  EXPECT_EQ(device->errors().disconnections, 0U);
}

TEST(HidUnplug, AStrangerInItsPlaceIsNotUsed)
{
  auto hid = std::make_unique<EmulatedHid>(modelOf(describedDevice()));
  std::string error;
  const auto device = HidDevice::open(hid->path(), error);
  ASSERT_TRUE(device) << error;
  hid.reset();
  palpate_hid_description stronger = describedDevice();
  stronger.maximum_force = 60.0F;
  EmulatedHid other(modelOf(stronger));
  Firmware firmware(other, press);
  ASSERT_TRUE(eventually(
    [&] { return device->status().find("describes itself otherwise") != std::string::npos; }));
  EXPECT_FALSE(device->read(0.0).valid);
  EXPECT_FALSE(device->write({ 1.0, 0.0, 0.0 }));
  EXPECT_EQ(firmware.forcesTaken(), 0U);
}

TEST(HidUnplug, PulledWhileTheDriverHangs)
{
  EmulatedHid hid(modelOf(describedDevice()));
  std::string error;
  const auto device = HidDevice::open(hid.path(), error);
  ASSERT_TRUE(device) << error;
  Firmware firmware(hid, press);
  ASSERT_TRUE(eventually([&] { return device->read(0.0).valid; }));
  firmware.hang(true);
  for (int i = 0; i < 600; ++i)
  {
    device->write({ 1.0, 0.0, 0.0 });
    std::this_thread::sleep_for(std::chrono::milliseconds(1)); // long enough for write() to block
  }
  hid.unplug();
  ASSERT_TRUE(eventually([&] { return device->errors().disconnections == 1; }));
  EXPECT_FALSE(device->read(0.0).valid);
  EXPECT_FALSE(device->write({ 1.0, 0.0, 0.0 }));
}
