// SPDX-License-Identifier: BSD-3-Clause
// Quantiles are compared with those of the sorted durations. Counts that another thread reads never
// decrease.
#include "Haptics/Servo/LatencyHistogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <thread>
#include <vector>

using palpate::LatencyCounts;
using palpate::LatencyHistogram;

namespace
{
/// Returns a quantile by its definition: the smallest value for which at least the fraction `share`
/// of all values is not larger.
std::int64_t exactQuantile(const std::vector<std::int64_t>& sorted, double share)
{
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

void expectQuantiles(const LatencyCounts& counts, std::vector<std::int64_t> all)
{
  std::sort(all.begin(), all.end());
  ASSERT_EQ(counts.total(), all.size());
  EXPECT_EQ(counts.worst(), all.back());
  for (const double share : { 0.0, 0.1, 0.5, 0.9, 0.99, 0.999, 1.0 })
  {
    const std::int64_t exact = exactQuantile(all, share);
    EXPECT_GE(counts.quantile(share), exact) << share;
    EXPECT_LE(counts.quantile(share), exact + exact / 32) << share; // the width of a class
  }
}

std::vector<std::int64_t> durations(int count, unsigned seed)
{
  std::mt19937 random(seed);
  std::lognormal_distribution<double> spread(10.0, 2.0); // median 22 µs
  std::vector<std::int64_t> all;
  for (int i = 0; i < count; ++i)
  {
    all.push_back(static_cast<std::int64_t>(spread(random)));
  }
  return all;
}
} // namespace

TEST(LatencyCounts, ClassesCoverEveryDurationOnceAndNarrowly)
{
  std::int64_t shortest = 0;
  for (std::size_t i = 0; i < LatencyCounts::Classes; ++i)
  {
    const std::int64_t longest = LatencyCounts::longestOf(i);
    ASSERT_GE(longest, shortest) << i;
    EXPECT_EQ(LatencyCounts::classOf(shortest), i);
    EXPECT_EQ(LatencyCounts::classOf(longest), i);
    EXPECT_LE(longest - shortest, shortest / 32) << i;
    shortest = longest + 1;
  }
  EXPECT_EQ(shortest, std::int64_t{ 1 } << 36); // ns; nearly 69 s
  EXPECT_EQ(LatencyCounts::classOf(shortest), LatencyCounts::Classes - 1);
  EXPECT_EQ(
    LatencyCounts::classOf(std::numeric_limits<std::int64_t>::max()), LatencyCounts::Classes - 1);
  EXPECT_EQ(LatencyCounts::classOf(-5), 0u);
}

TEST(LatencyHistogram, QuantilesAreThoseOfTheDurations)
{
  const auto histogram = std::make_unique<LatencyHistogram>();
  EXPECT_EQ(histogram->read().total(), 0u);
  EXPECT_EQ(histogram->read().quantile(0.5), 0);
  EXPECT_EQ(histogram->read().worst(), 0);
  const std::vector<std::int64_t> all = durations(20000, 1);
  for (const std::int64_t duration : all)
  {
    histogram->add(duration);
  }
  expectQuantiles(histogram->read(), all);
}

TEST(LatencyHistogram, AResetBeginsAnew)
{
  const auto histogram = std::make_unique<LatencyHistogram>();
  for (const std::int64_t duration : durations(1000, 2))
  {
    histogram->add(duration);
  }
  histogram->add(5000000000);
  histogram->reset();
  EXPECT_EQ(histogram->read().total(), 0u);
  EXPECT_EQ(histogram->read().worst(), 0);
  const std::vector<std::int64_t> later = durations(1000, 3);
  for (const std::int64_t duration : later)
  {
    histogram->add(duration);
  }
  expectQuantiles(histogram->read(), later);
}

TEST(LatencyHistogram, OfTwoReadingsTheLaterHoldsTheEarlier)
{
  constexpr std::uint64_t Durations = 100000;
  const auto histogram = std::make_unique<LatencyHistogram>();
  std::thread writer(
    [&]
    {
      for (std::uint64_t i = 0; i < Durations; ++i)
      {
        histogram->add(static_cast<std::int64_t>(i * 7919 % 1000003));
      }
    });
  std::uint64_t total = 0;
  std::int64_t worst = 0;
  while (total < Durations)
  {
    const LatencyCounts counts = histogram->read();
    ASSERT_GE(counts.total(), total);
    ASSERT_GE(counts.worst(), worst);
    // The counts are consistent: no quantile is above the worst value, and the class of the worst
    // value is not empty.
    ASSERT_EQ(counts.quantile(1.0), counts.worst());
    ASSERT_LE(counts.quantile(0.5), counts.quantile(0.99));
    total = counts.total();
    worst = counts.worst();
  }
  writer.join();
  EXPECT_EQ(histogram->read().total(), Durations);
}
