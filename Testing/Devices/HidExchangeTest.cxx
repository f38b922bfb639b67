// SPDX-License-Identifier: BSD-3-Clause
// A force device at 1 kHz through the real hidapi, with valid and invalid reports.
#include "Transports/Hid/HidDevice.h"

#include "FakeHidBus.h"
#include "Firmware.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
/// A sine of 0.5 Hz with an amplitude of 10 mm.
Vector3d wave(double seconds)
{
  return { 0.0, 0.0, 0.01 * std::sin(3.14159265 * seconds) };
}

std::unique_ptr<HidDevice> opened(const EmulatedHid& hid)
{
  std::string error;
  auto device = HidDevice::open(hid.path(), error);
  EXPECT_TRUE(device) << error;
  return device;
}

/// Calls `tick` at 1 kHz.
template <class Tick>
void run(int ticks, const Tick& tick)
{
  auto deadline = std::chrono::steady_clock::now();
  for (int i = 0; i < ticks; ++i)
  {
    tick(i);
    deadline += std::chrono::milliseconds(1);
    std::this_thread::sleep_until(deadline);
  }
}

void put(EmulatedHid& hid, const StateReport& state)
{
  HapticReportBytes bytes;
  pack(state, bytes);
  ASSERT_TRUE(hid.send(bytes.data(), bytes.size()));
}
} // namespace

TEST(HidExchange, DescribesItself)
{
  EmulatedHid hid(modelOf(describedDevice()));
  const auto device = opened(hid);
  EXPECT_EQ(device->specification().maximumForce, 6.0);
  EXPECT_EQ(device->specification().maximumStiffness, 2500.0);
  EXPECT_EQ(device->specification().maximumForceRate, 4000.0);
  EXPECT_STREQ(device->description().name.data(), "Palpate test");
  EXPECT_EQ(device->status(), "connected, waiting for its first report");
}

TEST(HidExchange, WithoutAFeatureReportItIsTreatedWithCare)
{
  HidModel model = modelOf(describedDevice());
  model.feature.clear();
  EmulatedHid hid(model);
  const auto device = opened(hid);
  EXPECT_EQ(device->specification().maximumForce, carefulSpecification().maximumForce);
  EXPECT_NE(device->status().find("does not describe itself"), std::string::npos);
}

TEST(HidExchange, OneKilohertzBothWays)
{
  constexpr int Ticks = 3000;
  EmulatedHid hid(modelOf(describedDevice()));
  const auto device = opened(hid);
  Firmware firmware(hid, wave);
  ASSERT_TRUE(eventually([&] { return device->read(0.0).valid; }));
  int fresh = 0;
  std::uint64_t sent = 0;
  run(Ticks,
    [&](int)
    {
      const DeviceSample sample = device->read(0.0);
      ASSERT_TRUE(sample.valid);
      EXPECT_LE(sample.position.norm(), 0.01);
      fresh += sample.fresh ? 1 : 0;
      device->write({ 0.0, 0.0, -100.0 * sample.position.z() });
      ++sent;
    });
  const int freshTicks = fresh;
  device->write({ 0.25, 0.5, -1.0 });
  ++sent;
  ASSERT_TRUE(eventually(
    [&] {
      return firmware.hasApplied({ 0.25, 0.5, -1.0 });
    }))
    << "the last force is applied";
  // The writer counts a replaced force after writing, so the last force may arrive before it is
  // counted.
  EXPECT_TRUE(eventually([&] { return firmware.forcesTaken() + device->errors().unsent == sent; }))
    << "no force is unaccounted for";
  EXPECT_TRUE(eventually(
    [&]
    {
      fresh += device->read(0.0).fresh ? 1 : 0;
      return fresh > Ticks / 10;
    }))
    << "readings go on, however few of the ticks above had a new one: see what is printed";
  const DeviceErrors errors = device->errors();
  EXPECT_EQ(errors.malformed, 0U);
  EXPECT_EQ(errors.stale, 0U);
  EXPECT_LE(errors.lost, firmware.statesNotSent()) << "every state that could be sent has come";
  EXPECT_EQ(firmware.state().refused, 0U) << "every force is sound and in order";
  EXPECT_EQ(device->status(), "connected");

  std::vector<std::uint32_t> delays = firmware.delays();
  std::sort(delays.begin(), delays.end());
  std::printf("state → force → device: median %u, 99 %% %u, worst %u ticks of the device; %d of %d "
              "ticks fresh, %llu forces overtaken\n",
    delays[delays.size() / 2], delays[delays.size() * 99 / 100], delays.back(), freshTicks, Ticks,
    static_cast<unsigned long long>(errors.unsent));
}

TEST(HidExchange, WhatIsNoReportIsCountedAndNotUsed)
{
  EmulatedHid hid(modelOf(describedDevice()));
  const auto device = opened(hid);
  StateReport state;
  state.sequence = 100;
  state.position = { 0.25, 0.0, 0.0 };
  put(hid, state);
  ASSERT_TRUE(eventually([&] { return device->read(0.0).valid; }));

  state.sequence = 200;
  state.position = { 0.5, 0.5, 0.5 };
  std::array<std::uint8_t, 96> bytes{};
  HapticReportBytes report;
  const auto refused = [&](std::size_t size, std::uint64_t count)
  {
    std::copy(report.begin(), report.end(), bytes.begin());
    ASSERT_TRUE(hid.send(bytes.data(), size));
    EXPECT_TRUE(eventually([&] { return device->errors().malformed == count; })) << size;
  };
  pack(state, report);
  report[20] ^= 0x10; // wrong checksum
  refused(64, 1);
  pack(state, report);
  refused(63, 2); // the report is too short
  refused(1, 3);
  report[60] ^= 1;
  refused(
    96, 5); // too long: hidapi delivers 64 bytes; here the other 32 are a second, short report
  pack(state, report);
  report[2] = 2; // wrong version
  refused(64, 6);
  pack(ForceReport(), report); // a report of the wrong direction
  refused(64, 7);
  state.velocity.y() = std::nan("");
  pack(state, report);
  refused(64, 8);
  report.fill(0);
  refused(64, 9);
  const DeviceSample sample = device->read(0.0);
  EXPECT_TRUE(sample.valid);
  EXPECT_FALSE(sample.fresh);
  EXPECT_EQ(sample.position, Vector3d(0.25, 0.0, 0.0));

  state = StateReport();
  state.sequence = 101;
  state.position = { 0.125, 0.0, 0.0 };
  put(hid, state);
  EXPECT_TRUE(eventually([&] { return device->read(0.0).position.x() == 0.125; }))
    << "sound ones are read as before";
}

TEST(HidExchange, OldReportsAreCountedAndNotUsed)
{
  EmulatedHid hid(modelOf(describedDevice()));
  const auto device = opened(hid);
  StateReport state;
  for (const std::uint32_t number : { 0xFFFFFFFEU, 0U, 0xFFFFFFFFU, 0U, 3U })
  {
    state.sequence = number; // wraps around; one comes late, one twice, two never
    state.position.x() = number == 3U ? 0.5 : 0.25;
    put(hid, state);
  }
  ASSERT_TRUE(eventually([&] { return device->read(0.0).position.x() == 0.5; }));
  EXPECT_EQ(device->errors().stale, 2U);
  EXPECT_EQ(device->errors().lost, 1U + 2U);
  EXPECT_EQ(device->errors().malformed, 0U);
}

TEST(HidExchange, ADeviceThatDoesNotReadDelaysNobody)
{
  EmulatedHid hid(modelOf(describedDevice()));
  const auto device = opened(hid);
  Firmware firmware(hid, wave);
  ASSERT_TRUE(eventually([&] { return device->read(0.0).valid; }));
  firmware.hang(true);
  // The pipe to the device is full after about 300 reports; then the writer's thread waits in
  // write().
  std::uint64_t sent = 0;
  run(600,
    [&](int)
    {
      device->write({ 1.0, 0.0, 0.0 });
      ++sent;
    });
  for (int i = 0; i < 5000; ++i, ++sent)
  {
    device->write({ 0.5, 0.0, 0.0 });
  }
  firmware.hang(false);
  device->write({ 0.25, 0.0, 0.0 });
  ++sent;
  ASSERT_TRUE(eventually(
    [&] {
      return firmware.hasApplied({ 0.25, 0.0, 0.0 });
    }))
    << "the newest, as soon as it reads again";
  EXPECT_TRUE(eventually([&] { return firmware.forcesTaken() + device->errors().unsent == sent; }));
  EXPECT_GT(device->errors().unsent, 4000U);
}

TEST(HidExchange, AtTheEndTheAmplifiersAreOff)
{
  EmulatedHid hid(modelOf(describedDevice()));
  auto device = opened(hid);
  Firmware firmware(hid, wave);
  ASSERT_TRUE(eventually([&] { return device->read(0.0).valid; }));
  device->write({ 1.0, 0.0, 0.0 });
  ASSERT_TRUE(eventually([&] { return firmware.hasApplied({ 1.0, 0.0, 0.0 }); }));
  EXPECT_TRUE(firmware.state().enabled);
  device.reset();
  ASSERT_TRUE(eventually([&] { return !firmware.state().enabled; }))
    << "told so: the watchdog takes the force away, but leaves this as it is";
  EXPECT_EQ(firmware.motors(), Vector3d::Zero());
}

TEST(HidExchange, ADriverThatHangsDoesNotHangTheProgram)
{
  EmulatedHid hid(modelOf(describedDevice()));
  auto device = opened(hid);
  Firmware firmware(hid, wave);
  ASSERT_TRUE(eventually([&] { return device->read(0.0).valid; }));
  firmware.hang(true);
  run(600, [&](int) { device->write({ 1.0, 0.0, 0.0 }); });
  device.reset(); // returns although write() does not
}

TEST(HidExchange, AHostThatHangsHoldsItsForceNoLongerThanItSaid)
{
  EmulatedHid hid(modelOf(describedDevice()));
  const auto device = opened(hid);
  Firmware firmware(hid, wave);
  ASSERT_TRUE(eventually([&] { return device->read(0.0).valid; }));
  device->holdFor(6e-3);
  device->write({ 1.0, 0.0, 0.0 }); // no further force follows
  ASSERT_TRUE(eventually([&] { return firmware.state().expired == 1; }));
  EXPECT_EQ(firmware.motors(), Vector3d::Zero());
  EXPECT_EQ(firmware.state().watchdog, 6000U) << "not the 20 ms of the device's time-out";
}

TEST(HidExchange, SilenceIsSeenAsSuch)
{
  EmulatedHid hid(modelOf(describedDevice()));
  const auto device = opened(hid);
  Firmware firmware(hid, wave);
  ASSERT_TRUE(eventually([&] { return device->read(0.0).valid; }));
  device->write({ 1.0, 0.0, 0.0 });
  ASSERT_TRUE(eventually([&] { return firmware.hasApplied({ 1.0, 0.0, 0.0 }); }));
  ASSERT_TRUE(eventually([&] { return firmware.state().expired == 1; })) << "the device's watchdog";
  EXPECT_EQ(firmware.motors(), Vector3d::Zero());
  firmware.hang(true);
  int silent = 0; // successive ticks without a new reading
  EXPECT_TRUE(eventually(
    [&]
    {
      silent = device->read(0.0).fresh ? 0 : silent + 1;
      return silent == 50;
    }))
    << "for the host's watchdog, after what was on its way";
}
