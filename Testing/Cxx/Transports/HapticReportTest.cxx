// SPDX-License-Identifier: BSD-3-Clause
// The 64-byte reports, byte by byte; a damaged report is never accepted.
#include "Transports/Hid/HapticReport.h"

#include "KnownReports.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace haptic_report
{
using namespace palpate;
using palpate::NotANumber;
using namespace palpate::testing;

namespace
{
template <class Report>
ReportDefect defectOf(const HapticReportBytes& bytes)
{
  Report report;
  return parse(bytes.data(), bytes.size(), report);
}
} // namespace

TEST(HapticReport, CheckSumIsThatOfEthernet)
{
  // The check value of CRC-32/ISO-HDLC, used by IEEE 802.3 and zlib.
  const std::uint8_t digits[] = { '1', '2', '3', '4', '5', '6', '7', '8', '9' };
  EXPECT_EQ(reportCheckSum(digits, sizeof digits), 0xCBF43926U);
  EXPECT_EQ(reportCheckSum(digits, 0), 0U);
}

TEST(HapticReport, BytesAreThoseOfTheProtocol)
{
  EXPECT_EQ(packed(knownState()), StateBytes);
  EXPECT_EQ(packed(knownForce()), ForceBytes);
  EXPECT_EQ(packed(knownDescription()), DescriptionBytes);
  EXPECT_EQ(packed(HelloReport{ 0xDEADBEEF }), HelloBytes);
}

TEST(HapticReport, ParsesWhatStandsThere)
{
  StateReport state;
  ASSERT_EQ(parse(StateBytes.data(), StateBytes.size(), state), ReportDefect::None);
  EXPECT_TRUE(state.amplifiersOn);
  EXPECT_TRUE(state.fault);
  EXPECT_EQ(state.sequence, 7U);
  EXPECT_EQ(state.time, 0x0102030405060708U);
  EXPECT_EQ(state.position, knownState().position);
  EXPECT_EQ(state.velocity, knownState().velocity);
  EXPECT_EQ(state.buttons, 0x80000001U);
  EXPECT_EQ(state.forceSequence, 6U);

  ForceReport force;
  ASSERT_EQ(parse(ForceBytes.data(), ForceBytes.size(), force), ReportDefect::None);
  EXPECT_TRUE(force.enable);
  EXPECT_EQ(force.sequence, 0xFFFFFFFEU);
  EXPECT_EQ(force.time, 1234567890123U);
  EXPECT_EQ(force.force, knownForce().force);
  EXPECT_EQ(force.watchdog, 20000U);
  EXPECT_EQ(force.stateSequence, 77U);

  DescriptionReport description;
  ASSERT_EQ(
    parse(DescriptionBytes.data(), DescriptionBytes.size(), description), ReportDefect::None);
  EXPECT_EQ(packed(description), DescriptionBytes);
  EXPECT_STREQ(description.name.data(), "Palpate one");
  EXPECT_EQ(description.workspace, knownDescription().workspace);
  EXPECT_EQ(description.nonce, 99U);

  HelloReport hello;
  ASSERT_EQ(parse(HelloBytes.data(), HelloBytes.size(), hello), ReportDefect::None);
  EXPECT_EQ(hello.nonce, 0xDEADBEEFU);
}

TEST(HapticReport, EverySingleBitCounts)
{
  for (const HapticReportBytes& sound : { StateBytes, ForceBytes, DescriptionBytes, HelloBytes })
  {
    for (std::size_t bit = 0; bit < 8 * HapticReportSize; ++bit)
    {
      HapticReportBytes damaged = sound;
      damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
      ASSERT_NE(checkReport(damaged.data(), damaged.size()), ReportDefect::None) << bit;
    }
  }
}

TEST(HapticReport, EveryOtherLengthIsRefused)
{
  std::array<std::uint8_t, 256> room{};
  std::copy(StateBytes.begin(), StateBytes.end(), room.begin());
  StateReport state;
  for (std::size_t size = 0; size <= room.size(); ++size)
  {
    EXPECT_EQ(parse(room.data(), size, state),
      size == HapticReportSize ? ReportDefect::None : ReportDefect::Size)
      << size;
  }
  EXPECT_EQ(parse(nullptr, 0, state), ReportDefect::Size);
}

TEST(HapticReport, SaysWhatIsWrong)
{
  HapticReportBytes bytes = StateBytes;
  bytes[0] = 'Q';
  seal(bytes);
  EXPECT_EQ(defectOf<StateReport>(bytes), ReportDefect::Mark);
  for (const int version : { 0, 2, 255 })
  {
    bytes = StateBytes;
    bytes[2] = static_cast<std::uint8_t>(version);
    seal(bytes);
    EXPECT_EQ(defectOf<StateReport>(bytes), ReportDefect::Version) << version;
  }
  EXPECT_EQ(defectOf<StateReport>(ForceBytes), ReportDefect::Kind);
  EXPECT_EQ(defectOf<ForceReport>(StateBytes), ReportDefect::Kind);
  EXPECT_EQ(defectOf<DescriptionReport>(HelloBytes), ReportDefect::Kind);
  EXPECT_EQ(defectOf<HelloReport>(DescriptionBytes), ReportDefect::Kind);
  EXPECT_EQ(defectOf<StateReport>(HapticReportBytes{}), ReportDefect::Mark);
  EXPECT_STREQ(inWords(ReportDefect::CheckSum), "wrong check sum");
}

TEST(HapticReport, NumbersThatAreNoneAreRefusedAndNothingIsTaken)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double wrong : { NotANumber, infinity, -infinity })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      StateReport state = knownState();
      state.position[axis] = wrong;
      EXPECT_EQ(defectOf<StateReport>(packed(state)), ReportDefect::Content);
      state = knownState();
      state.velocity[axis] = wrong;
      const HapticReportBytes bytes = packed(state);
      StateReport before;
      before.sequence = 4711;
      EXPECT_EQ(parse(bytes.data(), bytes.size(), before), ReportDefect::Content);
      EXPECT_EQ(before.sequence, 4711U);
      ForceReport force = knownForce();
      force.force[axis] = wrong;
      EXPECT_EQ(defectOf<ForceReport>(packed(force)), ReportDefect::Content);
    }
  }
}

TEST(HapticReport, WhatIsNotNamedIsNotLookedAt)
{
  HapticReportBytes bytes = StateBytes;
  bytes[3] |= 0xF0;
  std::fill(bytes.begin() + 48, bytes.begin() + 60, std::uint8_t{ 0x55 });
  seal(bytes);
  StateReport state;
  ASSERT_EQ(parse(bytes.data(), bytes.size(), state), ReportDefect::None);
  EXPECT_EQ(packed(state), StateBytes);
}

TEST(HapticReport, ANameOfAllItsBytesNeedsNoZero)
{
  DescriptionReport description = knownDescription();
  std::memcpy(description.name.data(), "sixteen bytes ok", 17);
  const HapticReportBytes bytes = packed(description);
  DescriptionReport back;
  ASSERT_EQ(parse(bytes.data(), bytes.size(), back), ReportDefect::None);
  EXPECT_STREQ(back.name.data(), "sixteen bytes ok");
  EXPECT_EQ(back.nonce, 99U);
}

TEST(HapticReport, NoiseIsNoReport)
{
  // Random data with the right mark and version pass the checksum with a probability of 2⁻³². Of
  // 10⁶ reports, none is expected to pass.
  std::mt19937 random(20260801);
  for (int i = 0; i < 1000000; ++i)
  {
    HapticReportBytes bytes;
    for (std::size_t word = 0; word < HapticReportSize; word += 4)
    {
      const std::uint32_t value = static_cast<std::uint32_t>(random());
      std::memcpy(&bytes[word], &value, 4);
    }
    bytes[0] = HapticReportMark;
    bytes[2] = HapticReportVersion;
    ASSERT_EQ(checkReport(bytes.data(), bytes.size()), ReportDefect::CheckSum);
  }
}

TEST(DescribedSpecification, IsBelievedWhereItIsCredible)
{
  std::string replaced;
  const DeviceSpecification limits = specificationOf(knownDescription(), &replaced);
  EXPECT_EQ(replaced, "");
  EXPECT_EQ(limits.maximumForce, 6.0);
  EXPECT_EQ(limits.maximumStiffness, 2500.0);
  EXPECT_TRUE(std::isinf(limits.maximumForceRate));
  EXPECT_EQ(limits.maximumDamping, 8.0);
  EXPECT_EQ(limits.workspace, knownDescription().workspace); // flat, as for a planar device
  EXPECT_EQ(limits.rate, 4000.0);
  EXPECT_EQ(limits.sampleTimeOut, static_cast<double>(0.01F));
  EXPECT_TRUE(limits.outputsForce);
}

TEST(DescribedSpecification, WhatIsAbsurdIsReplacedByWhatIsCareful)
{
  const DeviceSpecification careful = carefulSpecification();
  for (const double absurd :
    { NotANumber, 0.0, -1.0, 1e30, std::numeric_limits<double>::infinity() })
  {
    DescriptionReport description = knownDescription();
    description.planar = false;
    description.maximumForce = description.maximumStiffness = description.maximumDamping = absurd;
    description.rate = description.sampleTimeOut = absurd;
    description.workspace.setConstant(absurd);
    description.maximumForceRate = absurd > 0.0 ? NotANumber : absurd;
    std::string replaced;
    const DeviceSpecification limits = specificationOf(description, &replaced);
    EXPECT_EQ(limits.maximumForce, careful.maximumForce);
    EXPECT_EQ(limits.maximumStiffness, careful.maximumStiffness);
    EXPECT_EQ(limits.maximumForceRate, careful.maximumForceRate);
    EXPECT_EQ(limits.maximumDamping, careful.maximumDamping);
    EXPECT_EQ(limits.workspace, careful.workspace);
    EXPECT_EQ(limits.rate, careful.rate);
    EXPECT_EQ(limits.sampleTimeOut, careful.sampleTimeOut);
    EXPECT_EQ(std::count(replaced.begin(), replaced.end(), ';'), 8); // nine values are replaced
    EXPECT_NE(replaced.find("maximum force "), std::string::npos) << replaced;
  }
}

TEST(DescribedSpecification, InputOnlyFeelsNothing)
{
  DescriptionReport description = knownDescription();
  description.outputsForce = false;
  description.maximumForce = 0.0;
  std::string replaced;
  const DeviceSpecification limits = specificationOf(description, &replaced);
  EXPECT_EQ(replaced, "");
  EXPECT_FALSE(limits.outputsForce);
  EXPECT_EQ(limits.maximumForce, 0.0);
}
} // namespace haptic_report
