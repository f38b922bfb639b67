// SPDX-License-Identifier: BSD-3-Clause
// Orientation and torque in the 64-byte reports, from both sides; and compatibility with an older
// side that supports neither.
#include "Transports/Hid/HapticReport.h"

#include "KnownReports.h"

#include "palpate_hid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

using namespace palpate;
using namespace palpate::testing;
using Eigen::Vector3d;

namespace
{
/// Components are sent in single precision, with an error of 6e-8 of at most 1. The fourth
/// component is computed from the other three, with at most √3 times this error.
constexpr double Single = 2e-7;

void putSingle(HapticReportBytes& bytes, std::size_t offset, float value)
{
  std::memcpy(bytes.data() + offset, &value, sizeof value); // this test needs a little-endian host
}

/// Rotation between two orientations, rad; q and -q are equal.
double apart(const ToolOrientation& a, const ToolOrientation& b)
{
  return turnBetween(a, b).norm();
}

ToolOrientation anyOrientation(std::mt19937& random)
{
  std::normal_distribution<double> gauss;
  Eigen::Vector4d four;
  for (double& component : four)
  {
    component = gauss(random);
  }
  four.normalize();
  return { four[0], four[1], four[2], four[3] };
}
} // namespace

TEST(TorqueReport, BytesAreThoseOfTheProtocol)
{
  EXPECT_EQ(packed(knownTurnedState()), TurnedStateBytes);
  EXPECT_EQ(packed(knownTorque()), TorqueBytes);
  EXPECT_EQ(packed(knownTorqueDescription()), TorqueDescriptionBytes);
  StateReport state;
  ASSERT_EQ(parse(TurnedStateBytes.data(), 64, state), ReportDefect::None);
  EXPECT_LE(apart(state.orientation, knownTurnedState().orientation), 2.0 * Single);
  EXPECT_GT(state.orientation.y(), 0.0); // the largest component is sent as positive
  EXPECT_EQ(state.forceSequence, 6U);
  ForceReport force;
  ASSERT_EQ(parse(TorqueBytes.data(), 64, force), ReportDefect::None);
  EXPECT_EQ(force.torque, knownTorque().torque);
  EXPECT_EQ(force.force, knownForce().force);
  DescriptionReport description;
  ASSERT_EQ(parse(TorqueDescriptionBytes.data(), 64, description), ReportDefect::None);
  EXPECT_EQ(packed(description), TorqueDescriptionBytes);
  EXPECT_STREQ(description.name.data(), "Pen");
  EXPECT_EQ(description.maximumTorque, 0.25);
}

TEST(TorqueReport, EveryOrientationArrives)
{
  std::mt19937 random(2);
  for (int i = 0; i < 4000; ++i)
  {
    StateReport report = knownState();
    report.orientation = i < 8 ? ToolOrientation(i % 4 == 0, i % 4 == 1, i % 4 == 2, i % 4 == 3)
                               : anyOrientation(random);
    report.orientation.coeffs() *= i < 4 ? -1.0 : 1.0;
    const HapticReportBytes bytes = packed(report);
    StateReport back;
    ASSERT_EQ(parse(bytes.data(), bytes.size(), back), ReportDefect::None);
    ASSERT_TRUE(isTold(back.orientation));
    ASSERT_NEAR(back.orientation.norm(), 1.0, 1e-15);
    ASSERT_LE(apart(back.orientation, report.orientation), 4.0 * Single) << i;
    // The device's side in C sends the same bytes, except for single-precision rounding.
    palpate_hid hid{};
    palpate_hid_start(&hid, 6.0F, 20000);
    const ToolOrientation& told = report.orientation;
    const palpate_hid_reading reading = { { 0 }, { 0 }, 0, false,
      { static_cast<float>(told.w()), static_cast<float>(told.x()), static_cast<float>(told.y()),
        static_cast<float>(told.z()) } };
    HapticReportBytes sent;
    palpate_hid_state(&hid, 1, &reading, sent.data());
    ASSERT_EQ(parse(sent.data(), sent.size(), back), ReportDefect::None);
    ASSERT_LE(apart(back.orientation, report.orientation), 4.0 * Single) << i;
  }
}

TEST(TorqueReport, ADeviceOfBeforeTellsNoTurnAndNoTorque)
{
  StateReport state = knownTurnedState(); // old content must be overwritten
  ASSERT_EQ(parse(StateBytes.data(), 64, state), ReportDefect::None);
  EXPECT_FALSE(isTold(state.orientation));
  DescriptionReport description = knownTorqueDescription();
  ASSERT_EQ(parse(DescriptionBytes.data(), 64, description), ReportDefect::None);
  EXPECT_FALSE(description.outputsTorque);
  EXPECT_STREQ(description.name.data(), "Palpate one");
  const DeviceSpecification specification = specificationOf(description);
  EXPECT_FALSE(specification.outputsTorque);
  EXPECT_EQ(specification.maximumTorque, 0.0);
  ForceReport force = knownTorque();
  ASSERT_EQ(parse(ForceBytes.data(), 64, force), ReportDefect::None);
  EXPECT_EQ(force.torque, Vector3d::Zero());
  // An older host reads the name up to its zero byte. All other bytes are as before.
  HapticReportBytes seen = TorqueDescriptionBytes;
  EXPECT_EQ(seen[43], 0);
  seen[3] = DescriptionBytes[3];
  EXPECT_TRUE(std::equal(seen.begin(), seen.begin() + 40, DescriptionBytes.begin()));
  EXPECT_TRUE(std::equal(seen.begin() + 56, seen.begin() + 60, DescriptionBytes.begin() + 56));
}

TEST(TorqueReport, WhatIsNoOrientationOrTorqueIsRefused)
{
  const float wrongs[] = { std::numeric_limits<float>::quiet_NaN(),
    std::numeric_limits<float>::infinity(), 0.9F };
  for (const float wrong : wrongs)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      HapticReportBytes bytes =
        TurnedStateBytes; // 0.9² alone exceeds the remainder of the largest component
      putSingle(bytes, 48 + 4 * i, wrong);
      seal(bytes);
      StateReport state;
      state.sequence = 4711;
      EXPECT_EQ(parse(bytes.data(), bytes.size(), state), ReportDefect::Content);
      EXPECT_EQ(state.sequence, 4711U);
      bytes[3] &= 3; // flagged as absent, so it is not read
      seal(bytes);
      EXPECT_EQ(parse(bytes.data(), bytes.size(), state), ReportDefect::None);
      bytes = TorqueBytes;
      putSingle(bytes, 36 + 4 * i, wrong);
      seal(bytes);
      ForceReport force;
      palpate_hid hid{};
      palpate_hid_start(&hid, 6.0F, 20000);
      const bool isNumber = std::isfinite(wrong);
      EXPECT_EQ(parse(bytes.data(), bytes.size(), force) == ReportDefect::None, isNumber);
      EXPECT_EQ(palpate_hid_receive(&hid, bytes.data(), bytes.size(), 0), isNumber);
    }
  }
}

TEST(TorqueReport, TheDeviceKeepsItsOwnLimitAndLetsGo)
{
  palpate_hid hid{};
  palpate_hid_start(&hid, 6.0F, 20000);
  float torque[3] = { 1.0F, 1.0F, 1.0F };
  EXPECT_FALSE(palpate_hid_torque(&hid, 1, torque)); // no torque has arrived yet
  EXPECT_EQ(torque[0], 0.0F);
  ASSERT_TRUE(palpate_hid_receive(&hid, TorqueBytes.data(), TorqueBytes.size(), 1000));
  EXPECT_TRUE(palpate_hid_torque(&hid, 1001, torque));
  EXPECT_EQ(torque[0], 0.0F); // firmware without torque support receives no torque
  hid.maximum_torque = 1.0F;
  EXPECT_TRUE(palpate_hid_torque(&hid, 1001, torque));
  EXPECT_EQ(torque[0], 0.0625F);
  EXPECT_EQ(torque[1], -0.125F);
  EXPECT_EQ(torque[2], 2e-3F);
  hid.maximum_torque = 0.05F;
  EXPECT_TRUE(palpate_hid_torque(&hid, 1001, torque));
  // Single-precision rounding
  EXPECT_NEAR(std::hypot(torque[0], torque[1], torque[2]), 0.05F, 1e-8F);
  EXPECT_LT(torque[1], 0.0F);
  EXPECT_FALSE(palpate_hid_torque(&hid, 1000 + 20001, torque)); // the watchdog has ended the torque
  EXPECT_EQ(torque[1], 0.0F);
}

TEST(TorqueReport, TheDeviceDescribesItsTorque)
{
  palpate_hid_description description = { true, true, 6.0F, 2500.0F,
    std::numeric_limits<float>::infinity(), 8.0F, { 0.08F, 0.06F, 0.0F }, 4000.0F, 0.01F, "Pen",
    true, 0.25F, 1.5F, std::numeric_limits<float>::infinity() };
  HapticReportBytes bytes;
  palpate_hid_describe(&description, 99, bytes.data());
  EXPECT_EQ(bytes, TorqueDescriptionBytes);
}

TEST(TorqueReport, ATorqueIsBelievedWhereItIsCredible)
{
  std::string replaced;
  DeviceSpecification specification = specificationOf(knownTorqueDescription(), &replaced);
  EXPECT_TRUE(specification.outputsTorque);
  EXPECT_EQ(specification.maximumTorque, 0.25);
  EXPECT_EQ(specification.maximumTorsionalStiffness, 1.5);
  EXPECT_EQ(specification.maximumTorqueRate, std::numeric_limits<double>::infinity());
  EXPECT_EQ(replaced.find("torque"), std::string::npos) << replaced;
  DescriptionReport wild = knownTorqueDescription();
  wild.maximumTorque = 50.0;
  wild.maximumTorsionalStiffness = std::nan("");
  wild.maximumTorqueRate = -1.0;
  specification = specificationOf(wild, &replaced);
  EXPECT_EQ(specification.maximumTorque, 0.02);
  EXPECT_EQ(specification.maximumTorsionalStiffness, 0.02);
  EXPECT_EQ(specification.maximumTorqueRate, 2.0);
  EXPECT_NE(
    replaced.find("maximum torque 50 N m is not credible, 0.02 N m is assumed"), std::string::npos)
    << replaced;
}
