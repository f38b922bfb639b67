// SPDX-License-Identifier: BSD-3-Clause
// The reader gets the newest value, never a partly written value, and no thread waits. This test
// also runs with the thread sanitizer.
#include "Haptics/Servo/LatestValue.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <thread>

TEST(LatestValue, TheNewestValueIsRead)
{
  palpate::LatestValue<int> slot(7);
  EXPECT_EQ(slot.read(), 7);
  slot.write(1);
  slot.write(2);
  slot.write(3);
  EXPECT_EQ(slot.read(), 3);
  EXPECT_EQ(slot.read(), 3);
  slot.write(4);
  EXPECT_EQ(slot.read(), 4);
}

TEST(LatestValue, WhatIsPreparedIsNotRead)
{
  palpate::LatestValue<int> slot(7);
  slot.prepare(1);
  EXPECT_EQ(slot.read(), 7);
  slot.write(2);
  slot.prepare(3);
  EXPECT_EQ(slot.read(), 2);
  slot.prepare(4);
  EXPECT_EQ(slot.read(), 2);
  slot.write(5);
  EXPECT_EQ(slot.read(), 5);
}

TEST(LatestValue, ValuesAreNeitherTornNorOutOfOrder)
{
  constexpr long Last = 200000;
  palpate::LatestValue<std::array<long, 16>> slot;
  std::thread writer(
    [&slot]
    {
      for (long i = 1; i <= Last; ++i)
      {
        std::array<long, 16> value;
        value.fill(-i);
        slot.prepare(value);
        value.fill(i);
        slot.write(value);
      }
    });
  long previous = 0;
  while (previous < Last)
  {
    const std::array<long, 16>& value = slot.read();
    for (const long part : value)
    {
      ASSERT_EQ(part, value[0]);
    }
    ASSERT_GE(value[0], previous);
    previous = value[0];
  }
  writer.join();
}
