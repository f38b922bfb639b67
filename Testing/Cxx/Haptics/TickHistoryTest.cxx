// SPDX-License-Identifier: BSD-3-Clause
// The ticks of the last seconds, compared with a search through a complete list.
#include "Haptics/Servo/TickHistory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace
{
palpate::Tick tickAt(double time, unsigned number)
{
  palpate::Tick tick;
  tick.time = time;
  tick.scene = number; // distinguishes the ticks
  return tick;
}

/// Numbers of the ticks that are less than `seconds` older than the last tick, with a tolerance of
/// half a period.
std::vector<unsigned> within(const std::vector<double>& times, double seconds, double rate)
{
  std::vector<unsigned> numbers;
  for (unsigned i = 0; i < times.size(); ++i)
  {
    if (times[i] >= times.back() - seconds + 0.5 / rate)
    {
      numbers.push_back(i);
    }
  }
  return numbers;
}

void expectSame(const palpate::TickHistory& history, const std::vector<unsigned>& numbers)
{
  ASSERT_EQ(history.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    ASSERT_EQ(history[i].scene, numbers[i]);
  }
}
} // namespace

TEST(TickHistory, HoldsSecondsTimesRate)
{
  palpate::TickHistory history(0.5, 1000.0);
  for (unsigned i = 0; i < 2345; ++i)
  {
    history.add(tickAt(0.001 * i, i));
    ASSERT_EQ(history.size(), std::min(i + 1, 500U)); // 0.5 s at 1 kHz
    ASSERT_EQ(history[history.size() - 1].scene, i);
    ASSERT_EQ(history.added(), i + 1);
  }
  EXPECT_EQ(history[0].scene, 1845U);
  EXPECT_DOUBLE_EQ(history[0].time, 1.845);
}

TEST(TickHistory, IsTheSearchedListWhereTicksAreMissed)
{
  std::mt19937 random(7);
  std::geometric_distribution<int> skipped(0.6);
  std::uniform_int_distribution<int> pause(0, 60);
  palpate::TickHistory history(0.04, 1000.0);
  std::vector<double> times;
  long long tick = 0;
  for (unsigned i = 0; i < 2000; ++i)
  {
    tick +=
      1 + skipped(random) + (pause(random) == 0 ? 70 : 0); // sometimes longer than the history
    times.push_back(0.001 * static_cast<double>(tick));
    history.add(tickAt(times.back(), i));
    expectSame(history, within(times, 0.04, 1000.0));
  }
}

TEST(TickHistory, OfNoTimeIsEmptyButCounts)
{
  palpate::TickHistory history(0.0, 1000.0);
  history.add(tickAt(1.0, 0));
  history.add(tickAt(2.0, 1));
  EXPECT_EQ(history.size(), 0U);
  EXPECT_EQ(history.added(), 2U);
}

TEST(TickHistory, HoldsABoundedNumberWhateverTheTimes)
{
  palpate::TickHistory history(0.01, 1000.0);
  for (unsigned i = 0; i < 100; ++i)
  {
    history.add(tickAt(1.0, i)); // the time does not advance
  }
  EXPECT_EQ(history.size(), 11U);
  EXPECT_EQ(history[10].scene, 99U);
}
