// SPDX-License-Identifier: BSD-3-Clause
// How many threads loops take: what the environment says, and a limit in the thread that set it.
// Run once more with PALPATE_THREADS=3.
#include "Mechanics/ThreadCount.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

using palpate::threadCount;
using palpate::ThreadLimit;

TEST(ThreadCount, EnvironmentIsTheMost)
{
  const char* text = std::getenv("PALPATE_THREADS");
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  EXPECT_EQ(threadCount(), text == nullptr ? cores : std::stoul(text));
  const ThreadLimit more(1000);
  EXPECT_EQ(threadCount(), text == nullptr ? 1000 : std::stoul(text));
  const ThreadLimit one(1);
  EXPECT_EQ(threadCount(), 1U);
}

TEST(ThreadCount, InnermostHoldsInItsThreadAlone)
{
  const std::size_t before = threadCount();
  EXPECT_GE(before, 1U);
  {
    const ThreadLimit outer(3);
    EXPECT_EQ(threadCount(), 3U);
    {
      const ThreadLimit inner(2);
      EXPECT_EQ(threadCount(), 2U);
      const ThreadLimit none(0);
      EXPECT_EQ(threadCount(), 2U);
    }
    EXPECT_EQ(threadCount(), 3U);
    std::size_t elsewhere = 0;
    std::thread([&elsewhere] { elsewhere = threadCount(); }).join();
    EXPECT_EQ(elsewhere, before);
  }
  EXPECT_EQ(threadCount(), before);
}
