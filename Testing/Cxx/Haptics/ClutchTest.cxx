// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/DeviceEnd.h"

#include <gtest/gtest.h>

#include <cmath>

using Eigen::Vector3d;
using palpate::Clutch;
using palpate::ForceRamp;

namespace
{
constexpr double Period = 1e-3; // s
constexpr std::uint32_t Button = 2;

/// Position of a moving hand, mm.
Vector3d handAt(int tick)
{
  return { 0.1 * tick, std::sin(0.3 * tick), -2.0 };
}
} // namespace

TEST(Clutch, WithoutItsButtonTheTipIsTheHandToTheBit)
{
  Clutch none;
  Clutch other(Button);
  for (int i = 0; i < 100; ++i)
  {
    EXPECT_EQ(none.follow(handAt(i), 0xffffffffU, Period), handAt(i));
    EXPECT_EQ(other.follow(handAt(i), ~Button, Period), handAt(i));
  }
  EXPECT_TRUE(std::signbit(none.follow(Vector3d(-0.0, 0, 0), 0, Period).x()));
  EXPECT_EQ(none.forceShare(), 1.0);
  EXPECT_EQ(other.forceShare(), 1.0);
}

TEST(Clutch, TheTipStaysWhileHeldAndGoesOnFromThere)
{
  Clutch clutch(Button | 8);
  Vector3d offset = Vector3d::Zero();
  Vector3d last = clutch.follow(handAt(0), 0, Period);
  for (int i = 1; i < 400; ++i)
  {
    const bool held = i / 50 % 2 == 1;
    const bool wasHeld = (i - 1) / 50 % 2 == 1;
    const std::uint32_t buttons = held ? (i < 200 ? Button : 8) : 1;
    const Vector3d tip = clutch.follow(handAt(i), buttons, Period);
    EXPECT_EQ(clutch.isHeld(), held);
    // Also in the tick of the release: the tip does not jump, for any motion of the hand.
    if (wasHeld)
    {
      EXPECT_EQ(tip, last);
      offset = tip - handAt(i);
    }
    else // also in the tick of the press: the tip moves with the hand
    {
      EXPECT_LE((tip - handAt(i) - offset).norm(), 1e-13); // rounding error for positions of 40 mm
    }
    last = tip;
  }
  EXPECT_GT(offset.norm(), 10.0);
  clutch.reset();
  EXPECT_EQ(clutch.follow(handAt(7), 0, Period), handAt(7));
}

TEST(Clutch, ForceFadesAndComesBackStraightInTime)
{
  Clutch clutch(Button);
  clutch.follow(handAt(0), 0, Period);
  // 1 ms of 50 ms is a fiftieth per tick, and never more. Sums of fiftieths are exact up to
  // rounding.
  for (int i = 1; i <= 60; ++i)
  {
    clutch.follow(handAt(i), Button, Period);
    EXPECT_NEAR(clutch.forceShare(), std::max(0.0, 1.0 - 0.02 * i), 1e-14);
  }
  EXPECT_EQ(clutch.forceShare(), 0.0);
  for (int i = 1; i <= 60; ++i)
  {
    clutch.follow(handAt(i), 0, Period);
    EXPECT_NEAR(clutch.forceShare(), std::min(1.0, 0.02 * i), 1e-14);
  }
  EXPECT_EQ(clutch.forceShare(), 1.0);
}

TEST(Clutch, AButtonThatBouncesMakesNoStep)
{
  Clutch clutch(Button);
  double share = 1.0;
  for (int i = 0; i < 300; ++i)
  {
    clutch.follow(handAt(i), i * i % 7 < 3 ? Button : 0, Period);
    EXPECT_LE(std::abs(clutch.forceShare() - share), 0.02 + 1e-14);
    share = clutch.forceShare();
  }
}

TEST(ForceRamp, ALateTickMakesItLongerNotSteeper)
{
  ForceRamp ramp(0.0);
  EXPECT_EQ(ramp.advance(1.0, 0.0), 0.0); // no time has passed
  EXPECT_EQ(ramp.advance(1.0, 3.0), 0.1); // after a delay of 3 s
  EXPECT_NEAR(ramp.advance(1.0, 0.0025), 0.15, 1e-15);
  EXPECT_NEAR(ramp.advance(0.0, 0.001), 0.13, 1e-15);
  for (int i = 0; i < 9; ++i)
  {
    ramp.advance(1.0, 3.0);
  }
  EXPECT_EQ(ramp.share(), 1.0); // exactly, not 1 - 1e-16
}
