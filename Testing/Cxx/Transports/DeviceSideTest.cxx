// SPDX-License-Identifier: BSD-3-Clause
// The device's side in C and the host's side in C++: each reads the other's output. Also the
// functions of the device's side alone: watchdog, enable flag and its own limit.
#include "Transports/Hid/HapticReport.h"
#include "KnownReports.h"
#include "Transports/Hid/ReportSequence.h"

#include "palpate_hid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

using namespace palpate;
using namespace palpate::testing;
using Eigen::Vector3d;

namespace
{
constexpr std::uint32_t Watchdog = 20000; // µs

struct Device
{
  palpate_hid hid{};
  Device() { palpate_hid_start(&this->hid, 6.0F, Watchdog); }

  bool receive(const ForceReport& report, std::uint64_t now)
  {
    HapticReportBytes bytes;
    pack(report, bytes);
    return palpate_hid_receive(&this->hid, bytes.data(), bytes.size(), now);
  }
  /// Returns the force on the motors; `on` is set to true if the amplifiers are on.
  Vector3d force(std::uint64_t now, bool& on)
  {
    float force[3];
    on = palpate_hid_force(&this->hid, now, force);
    return { static_cast<double>(force[0]), static_cast<double>(force[1]),
      static_cast<double>(force[2]) };
  }
};

ForceReport forceNumber(std::uint32_t sequence, const Vector3d& force = { 1.0, 2.0, 3.0 })
{
  ForceReport report;
  report.enable = true;
  report.sequence = sequence;
  report.force = force;
  report.watchdog = Watchdog;
  return report;
}
} // namespace

TEST(DeviceSide, TheHostReadsItsStates)
{
  Device device;
  device.hid.sequence = 6;
  device.hid.force_sequence = 6;
  const palpate_hid_reading reading = { { 0.125F, -0.5F, 1e-4F }, { -1.0F, 2.0F, 0.75F },
    0x80000001, true, {} };
  HapticReportBytes bytes;
  palpate_hid_state(&device.hid, 0x0102030405060708, &reading, bytes.data());
  bytes[3] |= 1; // amplifiers on, as in the known report; this device had no force
  const std::uint32_t sum = palpate_hid_check_sum(bytes.data(), 60);
  for (std::size_t i = 0; i < 4; ++i)
  {
    bytes[60 + i] = static_cast<std::uint8_t>(sum >> (8 * i));
  }
  EXPECT_EQ(bytes, StateBytes);

  StateReport state;
  palpate_hid_state(&device.hid, 5, &reading, bytes.data());
  ASSERT_EQ(parse(bytes.data(), bytes.size(), state), ReportDefect::None);
  EXPECT_EQ(state.sequence, 8U);
  EXPECT_FALSE(state.amplifiersOn);
  ASSERT_TRUE(device.receive(forceNumber(41), 6));
  palpate_hid_state(&device.hid, 7, &reading, bytes.data());
  ASSERT_EQ(parse(bytes.data(), bytes.size(), state), ReportDefect::None);
  EXPECT_TRUE(state.amplifiersOn);
  EXPECT_EQ(state.forceSequence, 41U);
  EXPECT_EQ(state.position, knownState().position);
  EXPECT_EQ(state.velocity, knownState().velocity);
}

TEST(DeviceSide, TheHostReadsItsDescription)
{
  palpate_hid_description description = { true, true, 6.0F, 2500.0F,
    std::numeric_limits<float>::infinity(), 8.0F, { 0.08F, 0.06F, 0.0F }, 4000.0F, 0.01F, {}, false,
    0.0F, 0.0F, 0.0F };
  std::memcpy(description.name, "Palpate one", 11);
  HapticReportBytes bytes;
  palpate_hid_describe(&description, 99, bytes.data());
  EXPECT_EQ(bytes, DescriptionBytes);
}

TEST(DeviceSide, ItReadsTheHostsForces)
{
  Device device;
  ASSERT_TRUE(device.receive(knownForce(), 1000));
  bool on = false;
  EXPECT_EQ(device.force(1001, on), knownForce().force);
  EXPECT_TRUE(on);
  std::uint32_t nonce = 0;
  EXPECT_TRUE(palpate_hid_hello(HelloBytes.data(), HelloBytes.size(), &nonce));
  EXPECT_EQ(nonce, 0xDEADBEEFU);
  EXPECT_FALSE(palpate_hid_hello(ForceBytes.data(), ForceBytes.size(), &nonce));
}

TEST(DeviceSide, ItRefusesWhatTheHostWouldRefuse)
{
  Device device;
  for (std::size_t bit = 0; bit < 8 * HapticReportSize; ++bit)
  {
    HapticReportBytes damaged = ForceBytes;
    damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    ASSERT_FALSE(palpate_hid_receive(&device.hid, damaged.data(), damaged.size(), 0)) << bit;
  }
  for (std::size_t size = 0; size < HapticReportSize; ++size)
  {
    ASSERT_FALSE(palpate_hid_receive(&device.hid, ForceBytes.data(), size, 0));
  }
  EXPECT_FALSE(palpate_hid_receive(&device.hid, StateBytes.data(), StateBytes.size(), 0));
  const double wrong[] = { std::nan(""), std::numeric_limits<double>::infinity() };
  for (const double value : wrong)
  {
    EXPECT_FALSE(device.receive(forceNumber(1, { 0.0, value, 0.0 }), 0));
  }
  EXPECT_EQ(device.hid.refused, 8U * HapticReportSize + HapticReportSize + 3U);
  bool on = true;
  EXPECT_EQ(device.force(0, on), Vector3d::Zero());
  EXPECT_FALSE(on);
}

TEST(DeviceSide, NoForceWithoutTheHost)
{
  Device device;
  bool on = true;
  EXPECT_EQ(device.force(0, on), Vector3d::Zero());
  EXPECT_FALSE(on);
  ASSERT_TRUE(device.receive(forceNumber(1), 1000));
  EXPECT_EQ(device.force(1000 + Watchdog, on), Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(device.force(1001 + Watchdog, on), Vector3d::Zero()) << "the first tick too late";
  EXPECT_FALSE(on);
  EXPECT_EQ(device.hid.expired, 1U);
  EXPECT_EQ(device.force(1000, on), Vector3d::Zero()) << "and it stays off until the next force";
  ASSERT_TRUE(device.receive(forceNumber(2), 50000));
  EXPECT_EQ(device.force(50001, on), Vector3d(1.0, 2.0, 3.0));
  ForceReport patient = forceNumber(3);
  patient.watchdog = 0xFFFFFFFF; // a host that requests more than the device allows
  ASSERT_TRUE(device.receive(patient, 60000));
  EXPECT_EQ(device.force(60001 + Watchdog, on), Vector3d::Zero());
  ForceReport off = forceNumber(4);
  off.enable = false;
  ASSERT_TRUE(device.receive(off, 90000));
  EXPECT_EQ(device.force(90000, on), Vector3d::Zero());
  EXPECT_FALSE(on);
}

TEST(DeviceSide, OldForcesAreNotAppliedAndANewHostIs)
{
  Device device;
  ASSERT_TRUE(device.receive(forceNumber(0xFFFFFFFF), 1000));
  ASSERT_TRUE(device.receive(forceNumber(0, { 2.0, 0.0, 0.0 }), 1001)) << "wraps around";
  EXPECT_FALSE(device.receive(forceNumber(0), 1002)) << "repeated";
  EXPECT_FALSE(device.receive(forceNumber(0xFFFFFFF0), 1003)) << "old";
  bool on = false;
  EXPECT_EQ(device.force(1004, on), Vector3d(2.0, 0.0, 0.0));
  EXPECT_TRUE(device.receive(forceNumber(0xFFFFFFF0), 1005 + Watchdog)) << "after the watchdog";
}

TEST(DeviceSide, TheForceIsWithinItsOwnLimit)
{
  Device device;
  bool on = false;
  ASSERT_TRUE(device.receive(forceNumber(1, { 30.0, -40.0, 0.0 }), 0));
  EXPECT_LT((device.force(0, on) - Vector3d(3.6, -4.8, 0.0)).norm(), 1e-6) << "float rounding";
  ASSERT_TRUE(device.receive(forceNumber(2, { 3e38, 3e38, 0.0 }), 0));
  EXPECT_EQ(device.force(0, on), Vector3d::Zero()) << "its length overflows: rather none";
}

TEST(DeviceSide, ItsDescriptorIsThatOfAVendorDevice)
{
  // Items of a report descriptor, Device Class Definition for HID 1.11, 6.2.2: the low two bits
  // give the size.
  std::size_t at = 0;
  int depth = 0;
  int mains = 0;
  while (at < PALPATE_HID_DESCRIPTOR_SIZE)
  {
    const std::uint8_t item = palpate_hid_report_descriptor[at];
    depth += (item & 0xFC) == 0xA0 ? 1 : (item & 0xFC) == 0xC0 ? -1 : 0;
    mains += (item & 0xFC) == 0x80 || (item & 0xFC) == 0x90 || (item & 0xFC) == 0xB0;
    at += 1 + ((item & 3) == 3 ? 4 : item & 3);
  }
  EXPECT_EQ(at, static_cast<std::size_t>(PALPATE_HID_DESCRIPTOR_SIZE));
  EXPECT_EQ(depth, 0);
  EXPECT_EQ(mains, 3) << "input, output, feature";
}
