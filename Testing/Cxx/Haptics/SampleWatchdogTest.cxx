// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/SafetyLinks.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

namespace sample_watchdog
{
using palpate::Infinity;
using palpate::NotANumber;
using palpate::SampleWatchdog;

TEST(SampleWatchdog, LostOnTheFirstTickAfterTheTimeOut)
{
  // Times that a double represents exactly: ticks of 1/1024 s, a time-out of 20 ticks.
  const double tick = 1.0 / 1024.0;
  SampleWatchdog watchdog(20.0 * tick);
  int now = 0;
  for (; now < 50; ++now)
  {
    EXPECT_FALSE(watchdog.isLost(now * tick, true));
  }
  for (int silent = 1; silent <= 20; ++silent, ++now) // the last new sample was at 49
  {
    EXPECT_FALSE(watchdog.isLost(now * tick, false)) << silent;
  }
  for (int silent = 21; silent <= 500; ++silent, ++now)
  {
    EXPECT_TRUE(watchdog.isLost(now * tick, false)) << silent;
  }
  // The first new sample is still treated as a loss, because the force has been held or zero since
  // the last sample.
  EXPECT_TRUE(watchdog.isLost(now * tick, true));
  EXPECT_FALSE(watchdog.isLost((now + 1) * tick, true));
  EXPECT_FALSE(watchdog.isLost((now + 2) * tick, false));
}

TEST(SampleWatchdog, ALoopThatStallsIsLostToo)
{
  SampleWatchdog watchdog(0.02);
  EXPECT_FALSE(watchdog.isLost(1.0, true));
  EXPECT_FALSE(watchdog.isLost(1.019, true));
  EXPECT_TRUE(watchdog.isLost(1.1, true));
  EXPECT_FALSE(watchdog.isLost(1.101, true));
}

TEST(SampleWatchdog, AClockThatGoesBack)
{
  SampleWatchdog watchdog(0.02);
  EXPECT_FALSE(watchdog.isLost(100.0, true));
  EXPECT_FALSE(watchdog.isLost(100.0, true)); // a repeated time is not a fault
  EXPECT_TRUE(watchdog.isLost(99.999, true));
  EXPECT_FALSE(watchdog.isLost(100.0, true)); // continues with the new clock
  EXPECT_TRUE(watchdog.isLost(3.0, false));
  EXPECT_FALSE(watchdog.isLost(3.01, false));
  EXPECT_TRUE(watchdog.isLost(3.03, false));
  watchdog.reset();
  EXPECT_FALSE(watchdog.isLost(1.0, true));
}

TEST(SampleWatchdog, TimeOutsThatAreNone)
{
  SampleWatchdog patient(Infinity);
  EXPECT_FALSE(patient.isLost(0.0, true));
  EXPECT_FALSE(patient.isLost(1e9, false));
  for (const double none : { -1.0, NotANumber, -Infinity })
  {
    SampleWatchdog watchdog(none);
    EXPECT_TRUE(watchdog.isLost(0.0, true)) << none;
    EXPECT_TRUE(watchdog.isLost(0.001, true)) << none;
  }
}
} // namespace sample_watchdog
