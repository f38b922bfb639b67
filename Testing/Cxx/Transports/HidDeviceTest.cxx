// SPDX-License-Identifier: BSD-3-Clause
// HidDevice between a tick and a device with arbitrary behaviour, on an emulated bus, so that the
// sanitizers see its threads. The tests with the real hidapi are in Testing/Devices.
#include "Transports/Hid/HidDevice.h"

#include "FakeHidBus.h"
#include "KnownReports.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
const std::string Path = "/dev/hidraw0";

HidEntry entryAtPath(const std::string& path)
{
  HidEntry entry;
  entry.path = path;
  entry.vendor = 0x1209;
  entry.product = 0x0001;
  entry.usagePage = 0xFF00;
  entry.usage = 0x50;
  entry.serial = "42";
  return entry;
}

/// A force device on a bus, with the host's device object.
struct Bench
{
  FakeHidBus bus;
  std::shared_ptr<FakeHidDevice> far;
  std::unique_ptr<HidDevice> device;
  std::uint32_t sequence = 0;

  explicit Bench(bool described = true)
  {
    this->plug(Path, described ? knownDescription() : DescriptionReport(), described);
    std::string error;
    this->device = HidDevice::open(Path, error, this->bus);
    EXPECT_EQ(error, "");
  }

  void plug(const std::string& path, const DescriptionReport& description, bool described = true)
  {
    this->far = std::make_shared<FakeHidDevice>(entryAtPath(path));
    if (described)
    {
      HapticReportBytes bytes;
      pack(description, bytes);
      this->far->Feature.assign(bytes.begin(), bytes.end());
    }
    this->bus.plug(this->far);
  }

  void sendState(const Vector3d& position, bool fault = false)
  {
    StateReport state;
    state.sequence = ++this->sequence;
    state.position = position;
    state.fault = fault;
    state.amplifiersOn = true;
    this->far->send(state);
  }

  /// Waits until the tick reads this position.
  bool arrives(const Vector3d& position)
  {
    return eventually(
      [&]
      {
        const DeviceSample sample = this->device->read(0.0);
        return sample.valid && sample.position == position;
      });
  }

  bool connect()
  {
    this->sendState({ 0.25, 0.0, 0.0 });
    return this->arrives({ 0.25, 0.0, 0.0 });
  }
};
} // namespace

TEST(HidDevice, TellsWhatItCannotOpen)
{
  FakeHidBus bus;
  std::string error;
  EXPECT_EQ(HidDevice::open("/dev/hidraw7", error, bus), nullptr);
  EXPECT_EQ(error, "there is no /dev/hidraw7");
}

TEST(HidDevice, IsWhatItDescribesItselfAs)
{
  Bench bench;
  ASSERT_TRUE(bench.device);
  const DeviceSpecification& limits = bench.device->specification();
  EXPECT_EQ(limits.maximumForce, 6.0);
  EXPECT_EQ(limits.maximumStiffness, 2500.0);
  EXPECT_EQ(limits.rate, 4000.0);
  EXPECT_STREQ(bench.device->description().name.data(), "Palpate one");
  EXPECT_EQ(bench.device->status(), "connected, waiting for its first report");
}

TEST(HidDevice, IsTreatedWithCareIfItDoesNot)
{
  Bench bench(false);
  ASSERT_TRUE(bench.device);
  EXPECT_EQ(bench.device->specification().maximumForce, carefulSpecification().maximumForce);
  EXPECT_NE(bench.device->status().find("does not describe itself"), std::string::npos);
}

TEST(HidDevice, NothingIsSentBeforeItHasSpoken)
{
  Bench bench;
  EXPECT_FALSE(bench.device->read(0.0).valid);
  for (int i = 0; i < 50; ++i)
  {
    EXPECT_FALSE(bench.device->write({ 1.0, 0.0, 0.0 }));
  }
  const std::uint8_t stranger[64] = { 1, 2, 3 };
  bench.far->send(stranger, sizeof stranger);
  ASSERT_TRUE(eventually([&] { return bench.device->errors().malformed == 1; }));
  EXPECT_FALSE(bench.device->write({ 1.0, 0.0, 0.0 }));
  EXPECT_TRUE(bench.far->written().empty());
}

TEST(HidDevice, TheNewestReportIsRead)
{
  Bench bench;
  for (int i = 1; i <= 100; ++i)
  {
    bench.sendState({ 0.0, 0.0, i / 1024.0 });
  }
  ASSERT_TRUE(bench.arrives({ 0.0, 0.0, 100 / 1024.0 }));
  EXPECT_FALSE(bench.device->read(0.0).fresh) << "it has been read";
  bench.sendState({ 0.5, 0.0, 0.0 });
  ASSERT_TRUE(eventually([&] { return bench.device->read(0.0).fresh; }));
  const DeviceSample sample = bench.device->read(0.0);
  EXPECT_TRUE(sample.valid);
  EXPECT_FALSE(sample.fresh);
  EXPECT_EQ(sample.position, Vector3d(0.5, 0.0, 0.0));
  EXPECT_EQ(bench.device->status(), "connected");
}

TEST(HidDevice, WhatIsNoneIsCountedAndNotUsed)
{
  Bench bench;
  ASSERT_TRUE(bench.connect());
  StateReport wrong;
  wrong.sequence = 1000;
  wrong.position = { 0.5, 0.5, 0.5 };
  HapticReportBytes bytes;
  pack(wrong, bytes);
  bench.far->send(bytes.data(), 10); // too short
  bytes[2] = 2;                      // wrong version
  bench.far->send(bytes.data(), bytes.size());
  pack(wrong, bytes);
  bytes[30] ^= 1; // wrong checksum
  bench.far->send(bytes.data(), bytes.size());
  bench.far->send(knownForce()); // wrong kind
  wrong.position.x() = std::nan("");
  bench.far->send(wrong);
  ASSERT_TRUE(eventually([&] { return bench.device->errors().malformed == 5; }));
  const DeviceSample sample = bench.device->read(0.0);
  EXPECT_TRUE(sample.valid)
    << "one bad report is no reason to let go; the watchdog sees to silence";
  EXPECT_FALSE(sample.fresh);
  EXPECT_EQ(sample.position, Vector3d(0.25, 0.0, 0.0));
}

TEST(HidDevice, OldReportsAreNotUsedAndLostOnesCounted)
{
  Bench bench;
  ASSERT_TRUE(bench.connect());
  bench.sequence += 3; // three reports are lost
  bench.sendState({ 0.5, 0.0, 0.0 });
  ASSERT_TRUE(bench.arrives({ 0.5, 0.0, 0.0 }));
  EXPECT_EQ(bench.device->errors().lost, 3U);
  bench.sequence -= 2; // one report arrives late, and another twice
  bench.sendState({ 0.75, 0.0, 0.0 });
  bench.sendState({ 0.75, 0.0, 0.0 });
  ASSERT_TRUE(eventually([&] { return bench.device->errors().stale == 2; }));
  EXPECT_EQ(bench.device->read(0.0).position, Vector3d(0.5, 0.0, 0.0));
}

TEST(HidDevice, ForcesArriveAsTheyAre)
{
  Bench bench;
  ASSERT_TRUE(bench.connect());
  EXPECT_TRUE(bench.device->write({ 1.5, -0.25, 0.5 }));
  ASSERT_TRUE(eventually([&] { return bench.far->written().size() == 1; }));
  const ForceReport report = bench.far->lastForce();
  EXPECT_EQ(report.force, Vector3d(1.5, -0.25, 0.5));
  EXPECT_TRUE(report.enable);
  EXPECT_EQ(report.stateSequence, 1U);
  EXPECT_EQ(report.watchdog, 10000U) << "its own time-out, 10 ms";
  EXPECT_TRUE(bench.device->write({ 30.0, -40.0, 0.0 }));
  ASSERT_TRUE(eventually([&] { return bench.far->written().size() == 2; }));
  EXPECT_LT((bench.far->lastForce().force - Vector3d(3.6, -4.8, 0.0)).norm(), 1e-6) << "float";
  EXPECT_EQ(bench.far->lastForce().sequence, report.sequence + 1);
}

TEST(HidDevice, EachForceIsToldForATime)
{
  Bench bench;
  ASSERT_TRUE(bench.connect());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  std::size_t sent = 0;
  for (const auto& [hold, told] : { std::pair(4.2e-3, 4200U), std::pair(0.0, 0U),
         std::pair(0.5, 10000U), std::pair(infinity, 10000U), std::pair(nan, 10000U) })
  {
    bench.device->holdFor(hold);
    EXPECT_TRUE(bench.device->write({ 1.5, 0.0, 0.0 }));
    ++sent;
    ASSERT_TRUE(eventually([&] { return bench.far->written().size() == sent; }));
    EXPECT_EQ(bench.far->lastForce().watchdog, told) << hold;
  }
}

TEST(HidDevice, AForceThatIsNoneIsSentAsZero)
{
  Bench bench;
  ASSERT_TRUE(bench.connect());
  const double infinity = std::numeric_limits<double>::infinity();
  std::size_t sent = 0;
  for (const double wrong : { std::nan(""), infinity, -infinity, 1e200 })
  {
    bench.device->write({ 1.0, 0.0, 0.0 });
    ASSERT_TRUE(eventually([&] { return bench.far->written().size() == sent + 1; }));
    EXPECT_FALSE(bench.device->write({ 0.0, wrong, 0.0 }));
    ASSERT_TRUE(eventually([&] { return bench.far->written().size() == sent + 2; }));
    EXPECT_EQ(bench.far->lastForce().force, Vector3d::Zero()) << wrong;
    sent += 2;
  }
}

TEST(HidDevice, AFaultTakesTheForceAway)
{
  Bench bench;
  ASSERT_TRUE(bench.connect());
  ASSERT_TRUE(bench.device->write({ 1.0, 0.0, 0.0 }));
  bench.sendState({ 0.5, 0.0, 0.0 }, true);
  ASSERT_TRUE(eventually([&] { return !bench.device->read(0.0).valid; }));
  EXPECT_FALSE(bench.device->write({ 1.0, 0.0, 0.0 }));
  ASSERT_TRUE(eventually([&] { return bench.far->lastForce().force == Vector3d::Zero(); }));
  EXPECT_EQ(bench.device->status(), "connected, but it reports a fault");
  bench.sendState({ 0.5, 0.0, 0.0 });
  EXPECT_TRUE(bench.arrives({ 0.5, 0.0, 0.0 }));
}

TEST(HidDevice, UnpluggedInMidContactAndBack)
{
  // In the first tick after the report of the loss, the sample is always invalid and no force is
  // accepted. The device returns with its serial number, at one of two paths.
  Bench bench;
  ASSERT_TRUE(bench.connect());
  for (int round = 0; round < 8; ++round)
  {
    const std::string before = round % 2 == 0 ? Path : "/dev/hidraw3";
    const std::string after = round % 2 == 0 ? "/dev/hidraw3" : Path;
    const auto gone = bench.far;
    std::thread plug([&] { bench.bus.unplug(before); });
    bool reported = false;
    for (int tick = 0; tick < 100000000 && !reported; ++tick)
    {
      reported = bench.device->errors().disconnections > static_cast<std::uint64_t>(round);
      const DeviceSample sample = bench.device->read(1e-3 * tick);
      const bool taken = bench.device->write({ 1.0, 0.0, 0.0 });
      if (reported)
      {
        EXPECT_FALSE(sample.valid);
        EXPECT_FALSE(taken);
      }
    }
    plug.join();
    ASSERT_TRUE(reported);
    EXPECT_EQ(bench.device->status(), "unplugged, waiting for it to return");
    bench.plug(after, knownDescription());
    ASSERT_TRUE(eventually(
      [&] { return bench.device->status() == "connected, waiting for its first report"; }));
    EXPECT_FALSE(bench.device->read(0.0).valid) << "the last state was before";
    EXPECT_FALSE(bench.device->write({ 1.0, 0.0, 0.0 }));
    bench.sequence = static_cast<std::uint32_t>(round);
    bench.sendState({ 0.0, round / 8.0, 0.5 });
    EXPECT_TRUE(bench.arrives({ 0.0, round / 8.0, 0.5 }));
    bench.device->write({ 2.0, 0.0, 0.0 });
    EXPECT_TRUE(eventually([&] { return bench.far->lastForce().force.x() == 2.0; }));
    EXPECT_TRUE(eventually([&] { return gone->openPorts() == 0; })) << "closed";
  }
  EXPECT_EQ(bench.device->errors().disconnections, 8U);
}

TEST(HidDevice, AnotherDeviceInItsPlaceIsNotUsed)
{
  Bench bench;
  ASSERT_TRUE(bench.connect());
  bench.bus.unplug(Path);
  DescriptionReport stronger = knownDescription();
  stronger.maximumForce = 60.0;
  bench.plug(Path, stronger);
  ASSERT_TRUE(eventually([&]
    { return bench.device->status().find("describes itself otherwise") != std::string::npos; }));
  bench.sendState({ 0.5, 0.0, 0.0 });
  EXPECT_FALSE(bench.device->read(0.0).valid);
  EXPECT_FALSE(bench.device->write({ 1.0, 0.0, 0.0 }));
  bench.bus.unplug(Path);
  bench.plug("/dev/hidraw1", knownDescription());
  ASSERT_TRUE(eventually(
    [&] { return bench.device->status() == "connected, waiting for its first report"; }));
}

TEST(HidDevice, SlowWritesAreSurvived)
{
  Bench bench;
  ASSERT_TRUE(bench.connect());
  bench.far->setWriteTime(std::chrono::milliseconds(5));
  constexpr int Ticks = 20000;
  for (int tick = 1; tick <= Ticks; ++tick)
  {
    bench.device->write({ 0.0, 0.0, tick / 32768.0 });
  }
  ASSERT_TRUE(eventually([&] { return bench.far->lastForce().force.z() == Ticks / 32768.0; }))
    << "the newest arrives in the end";
  EXPECT_TRUE(eventually(
    [&] { return bench.far->written().size() + bench.device->errors().unsent == Ticks; }))
    << "what was overtaken is counted";
  EXPECT_GT(bench.device->errors().unsent, 0U);
}

TEST(HidDevice, WritesThatFailAreToldAndCounted)
{
  Bench bench;
  ASSERT_TRUE(bench.connect());
  bench.far->refuse(true);
  bench.device->write({ 1.0, 0.0, 0.0 });
  ASSERT_TRUE(eventually([&] { return bench.device->errors().unsent == 1; }));
  EXPECT_FALSE(bench.device->write({ 1.0, 0.0, 0.0 }));
  EXPECT_EQ(bench.device->status(), "connected, but it does not take forces");
  bench.far->refuse(false);
  ASSERT_TRUE(eventually([&] { return bench.device->write({ 1.0, 0.0, 0.0 }); }));
}

TEST(HidDevice, SwitchesOffAtTheEnd)
{
  Bench bench;
  ASSERT_TRUE(bench.connect());
  bench.device->write({ 1.0, 0.0, 0.0 });
  ASSERT_TRUE(eventually([&] { return bench.far->written().size() == 1; }));
  bench.device.reset();
  EXPECT_EQ(bench.far->written().size(), 2U);
  EXPECT_FALSE(bench.far->lastForce().enable);
  EXPECT_EQ(bench.far->lastForce().force, Vector3d::Zero());
  EXPECT_EQ(bench.far->openPorts(), 0);
}

TEST(HidDevice, ADriverThatHangsDoesNotHangTheProgram)
{
  Bench bench;
  ASSERT_TRUE(bench.connect());
  bench.far->hang(true);
  bench.device->write({ 1.0, 0.0, 0.0 });
  bench.sendState({ 0.5, 0.0, 0.0 });
  EXPECT_TRUE(bench.arrives({ 0.5, 0.0, 0.0 })) << "reading goes on";
  bench.device.reset(); // returns although the writer's thread does not
  EXPECT_EQ(bench.far->openPorts(), 1);
  bench.far->hang(false);
  EXPECT_TRUE(eventually([&] { return bench.far->openPorts() == 0; })) << "and ends when it can";
}
