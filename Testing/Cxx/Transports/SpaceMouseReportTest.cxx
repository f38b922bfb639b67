// SPDX-License-Identifier: BSD-3-Clause
// The layouts of the SpaceMouse's reports.
#include "Transports/Hid/SpaceMouseReport.h"

#include <gtest/gtest.h>

#include <vector>

using Eigen::Vector3d;
using palpate::SpaceMouseState;
using palpate::takeSpaceMouseReport;

namespace
{
bool take(const std::vector<std::uint8_t>& report, SpaceMouseState& state)
{
  return takeSpaceMouseReport(report.data(), report.size(), state);
}
} // namespace

TEST(SpaceMouseReport, ClassicLayout)
{
  SpaceMouseState state;
  // Right 350 (0x015E), towards the user −350 (0xFEA2), down 175 (0x00AF).
  ASSERT_TRUE(take({ 1, 0x5E, 0x01, 0xA2, 0xFE, 0xAF, 0x00 }, state));
  EXPECT_EQ(state.push, Vector3d(1.0, -0.5, -1.0)) << "right, up, towards the user";
  EXPECT_EQ(state.turn, Vector3d::Zero());
  ASSERT_TRUE(take({ 2, 0, 0, 0x5E, 0x01, 0, 0 }, state));
  EXPECT_EQ(state.turn, Vector3d(0.0, 0.0, 1.0));
  EXPECT_EQ(state.push, Vector3d(1.0, -0.5, -1.0)) << "turning is another report";
}

TEST(SpaceMouseReport, WirelessLayout)
{
  SpaceMouseState state;
  ASSERT_TRUE(take({ 1, 0x5E, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0xA2, 0xFE }, state));
  EXPECT_EQ(state.push, Vector3d(1.0, 0.0, 0.0));
  EXPECT_EQ(state.turn, Vector3d(0.0, 1.0, 0.0));
}

TEST(SpaceMouseReport, Buttons)
{
  SpaceMouseState state;
  ASSERT_TRUE(take({ 3, 0x02 }, state));
  EXPECT_EQ(state.buttons, 2U);
  ASSERT_TRUE(take({ 3, 0x01, 0x80, 0x00, 0x80 }, state));
  EXPECT_EQ(state.buttons, 0x80008001U);
  ASSERT_TRUE(take({ 3, 0, 0, 0, 0, 0xFF, 0xFF }, state));
  EXPECT_EQ(state.buttons, 0U) << "no more than 32";
}

TEST(SpaceMouseReport, OtherLengthsAreRefusedAndOtherNumbersLeftAlone)
{
  SpaceMouseState state;
  ASSERT_TRUE(take({ 1, 0x5E, 0x01, 0, 0, 0, 0 }, state));
  for (const std::size_t size : { 0, 1, 2, 6, 8, 12 })
  {
    for (const std::uint8_t number : { 1, 2 })
    {
      std::vector<std::uint8_t> report(size, 0x11);
      if (size > 0)
      {
        report[0] = number;
      }
      EXPECT_FALSE(take(report, state)) << size;
    }
  }
  EXPECT_TRUE(take({ 0x17, 0x64, 0x00 }, state)) << "battery";
  EXPECT_EQ(state.push, Vector3d(1.0, 0.0, 0.0));
}
