// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/SafetyLinks.h"

#include <gtest/gtest.h>

#include <limits>

using palpate::EntryGate;

TEST(EntryGate, ClosedUntilOnceOutside)
{
  EntryGate gate(true, 0.0);
  for (int tick = 0; tick < 100; ++tick)
  {
    EXPECT_EQ(gate.share(1e-3 * tick, false), 0.0);
  }
  EXPECT_EQ(gate.share(0.1, true), 1.0);
  EXPECT_EQ(gate.share(0.101, false), 1.0);
  EXPECT_EQ(gate.share(0.102, false), 1.0);
  gate.close();
  EXPECT_EQ(gate.share(0.103, false), 0.0);
  EXPECT_EQ(gate.share(0.104, true), 1.0);
  EXPECT_EQ(gate.share(0.105, false), 1.0);
}

TEST(EntryGate, RampOfTheFirstTouch)
{
  EntryGate gate(true, 0.5);
  EXPECT_EQ(gate.share(0.0, false), 0.0);
  EXPECT_EQ(gate.share(1.0, true), 1.0); // the share applies to a force of zero
  EXPECT_EQ(gate.share(2.0, false), 0.0);
  EXPECT_EQ(gate.share(2.125, false), 0.25);
  EXPECT_EQ(gate.share(2.25, true), 0.5); // the ramp continues outside
  EXPECT_EQ(gate.share(2.375, false), 0.75);
  EXPECT_EQ(gate.share(2.5, false), 1.0);
  EXPECT_EQ(gate.share(3.0, true), 1.0);
  EXPECT_EQ(gate.share(4.0, false), 1.0); // a second contact has no ramp
  gate.close();
  EXPECT_EQ(gate.share(5.0, true), 1.0);
  EXPECT_EQ(gate.share(6.0, false), 0.0);
  EXPECT_EQ(gate.share(6.25, false), 0.5);
}

TEST(EntryGate, WithoutAGate)
{
  EntryGate gate(false, 0.0);
  EXPECT_EQ(gate.share(0.0, false), 1.0);
  gate.close();
  EXPECT_EQ(gate.share(0.0, false), 1.0);
  EntryGate ramp(false, 0.5);
  EXPECT_EQ(ramp.share(7.0, false), 0.0);
  EXPECT_EQ(ramp.share(7.25, false), 0.5);
}

TEST(EntryGate, RampsThatAreNone)
{
  for (const double none : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    EntryGate gate(true, none);
    EXPECT_EQ(gate.share(0.0, true), 1.0);
    EXPECT_EQ(gate.share(1.0, false), 1.0) << none;
  }
}
