// SPDX-License-Identifier: BSD-3-Clause
// The number of threads of loops: the value from the environment, and a limit that is valid in the
// thread that set it. The test also runs with PALPATE_THREADS=3.
#include "Mechanics/SharedWork.h"
#include "Mechanics/ThreadCount.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <thread>
#include <vector>

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

TEST(SharedWork, EachItemOnceAndNoMoreWhenStopped)
{
  for (const std::size_t threads : { 1, 3 })
  {
    const ThreadLimit limit(threads);
    std::vector<int> taken(100, 0);
    std::vector<double> told;
    const auto take = [&](std::size_t i) { ++taken[i]; };
    EXPECT_TRUE(palpate::shareWork(taken.size(), take,
      [&](double done)
      {
        told.push_back(done);
        return true;
      }));
    EXPECT_EQ(std::count(taken.begin(), taken.end(), 1), 100);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1.0);
    EXPECT_FALSE(palpate::shareWork(taken.size(), take, [](double) { return false; }));
    EXPECT_LE(*std::max_element(taken.begin(), taken.end()), 2);
    EXPECT_TRUE(palpate::shareWork(0, take));
  }
}
