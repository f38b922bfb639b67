// SPDX-License-Identifier: BSD-3-Clause
// Every value arrives in order, or its loss is counted. This test also runs with the thread
// sanitizer.
#include "Haptics/Servo/SampleRing.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <vector>

using palpate::SampleRing;

namespace
{
std::vector<long> drained(SampleRing<long>& ring)
{
  std::vector<long> values;
  const std::size_t count = ring.drain([&](long value) { values.push_back(value); });
  EXPECT_EQ(count, values.size());
  return values;
}
} // namespace

TEST(SampleRing, ValuesComeInOrderRoundAndRound)
{
  SampleRing<long> ring(5);
  EXPECT_EQ(ring.capacity(), 5u);
  long next = 0;
  long expected = 0;
  for (int round = 0; round < 20; ++round)
  {
    for (int i = 0; i < 1 + round % 5; ++i)
    {
      EXPECT_TRUE(ring.push(next++));
    }
    EXPECT_EQ(ring.size(), static_cast<std::size_t>(1 + round % 5));
    for (const long value : drained(ring))
    {
      EXPECT_EQ(value, expected++);
    }
  }
  EXPECT_EQ(expected, next);
  EXPECT_EQ(ring.size(), 0u);
  EXPECT_EQ(ring.overruns(), 0u);
}

TEST(SampleRing, WhatFindsNoRoomIsCountedAndWhatWaitsIsKept)
{
  SampleRing<long> ring(3);
  for (long i = 0; i < 7; ++i)
  {
    EXPECT_EQ(ring.push(i), i < 3);
  }
  EXPECT_EQ(ring.overruns(), 4u);
  EXPECT_EQ(drained(ring), (std::vector<long>{ 0, 1, 2 }));
  EXPECT_TRUE(ring.push(7));
  EXPECT_EQ(drained(ring), (std::vector<long>{ 7 }));
  EXPECT_EQ(ring.overruns(), 4u);
}

TEST(SampleRing, WhatIsPreparedIsNotDrained)
{
  SampleRing<long> ring(2);
  for (long i = 0; i < 5; ++i)
  {
    ring.prepare(-1);
    EXPECT_EQ(ring.size(), 0u);
    ring.push(2 * i);
    ring.prepare(-1);
    ring.push(2 * i + 1);
    ring.prepare(-1); // the ring is full
    EXPECT_EQ(drained(ring), (std::vector<long>{ 2 * i, 2 * i + 1 }));
  }
  EXPECT_EQ(ring.overruns(), 0u);
  SampleRing<long> none(0);
  none.prepare(-1);
  EXPECT_TRUE(drained(none).empty());
}

TEST(SampleRing, WithoutCapacityNothingIsKeptOrLost)
{
  SampleRing<long> ring(0);
  EXPECT_FALSE(ring.push(1));
  EXPECT_EQ(ring.overruns(), 0u);
  EXPECT_TRUE(drained(ring).empty());
}

TEST(SampleRing, ASinkThatThrowsKeepsItsValue)
{
  SampleRing<long> ring(4);
  ring.push(1);
  ring.push(2);
  ring.push(3);
  const auto refuseTwo = [](long value)
  {
    if (value == 2)
    {
      throw std::runtime_error("two");
    }
  };
  EXPECT_THROW(ring.drain(refuseTwo), std::runtime_error);
  EXPECT_EQ(drained(ring), (std::vector<long>{ 2, 3 }));
}

TEST(SampleRing, BetweenThreadsValuesAreWholeInOrderAndAccountedFor)
{
  using Values = std::array<long, 16>;
  constexpr long Last = 200000;
  SampleRing<Values> ring(64);
  long pushed = 0;
  std::atomic<bool> done{ false };
  std::thread writer(
    [&]
    {
      for (long i = 1; i <= Last; ++i)
      {
        Values values;
        values.fill(i);
        pushed += ring.push(values) ? 1 : 0;
      }
      done = true;
    });
  long previous = 0;
  long count = 0;
  bool finished = false;
  while (!finished)
  {
    finished = done; // read before the drain, so that the drain gets all values pushed before
    ring.drain(
      [&](const Values& values)
      {
        for (const long part : values)
        {
          ASSERT_EQ(part, values[0]);
        }
        ASSERT_GT(values[0], previous);
        previous = values[0];
        ++count;
      });
  }
  writer.join();
  EXPECT_GT(count, 0);
  EXPECT_EQ(count, pushed);
  EXPECT_EQ(ring.overruns(), static_cast<std::uint64_t>(Last - count));
}
