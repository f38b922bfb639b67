// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ParallelRanges.h"

#include "Contact/LargePages.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <utility>

namespace palpate
{
TEST(ParallelRanges, FewItemsAreOneRange)
{
  const std::size_t most = threadCount();
  EXPECT_EQ(rangeCount(0), 1U);
  EXPECT_EQ(rangeCount(1), 1U);
  EXPECT_EQ(rangeCount(2 * 8192 - 1), 1U);
  EXPECT_EQ(rangeCount(2 * 8192), std::min<std::size_t>(2, most));
  EXPECT_EQ(rangeCount(8192 * 1000), std::min<std::size_t>(1000, most));
}

TEST(ParallelRanges, CoverEachItemOnce)
{
  for (const std::size_t count : { 0, 1, 7, 8191, 8192, 16384, 16385, 100003 })
  {
    std::vector<std::uint8_t> visits(count, 0);
    std::vector<std::pair<std::size_t, std::size_t>> ranges;
    std::mutex guard;
    forRanges(count,
      [&](std::size_t first, std::size_t last)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          ++visits[i];
        }
        const std::lock_guard<std::mutex> lock(guard);
        ranges.emplace_back(first, last);
      });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), static_cast<std::ptrdiff_t>(count));
    EXPECT_EQ(ranges.size(), rangeCount(count));
    std::sort(ranges.begin(), ranges.end());
    EXPECT_EQ(ranges.front().first, 0U);
    EXPECT_EQ(ranges.back().second, count);
    for (std::size_t k = 1; k < ranges.size(); ++k)
    {
      EXPECT_EQ(ranges[k].first, ranges[k - 1].second);
    }
  }
}

TEST(ParallelRanges, AreAsManyAsTheThreadsThereMayBe)
{
  for (const std::size_t threads : { 1, 2, 8 })
  {
    const ThreadLimit limit(threads);
    std::atomic<std::size_t> ranges{ 0 };
    forRanges(8 * 8192, [&ranges](std::size_t, std::size_t) { ++ranges; });
    EXPECT_EQ(ranges, threads);
  }
}

TEST(LargePages, AreAlignedAndHoldWhatIsPut)
{
  constexpr std::size_t page = std::size_t{ 1 } << 21;
  const auto place = [](const auto& values)
  { return reinterpret_cast<std::uintptr_t>(values.data()); };
  for (const std::size_t count : { std::size_t{ 1 }, std::size_t{ 1000 }, page / 4, page })
  {
    LargeVector<std::int32_t> values(count);
    std::iota(values.begin(), values.end(), 0);
    EXPECT_EQ(place(values) % 64, 0U);
    if (count * sizeof(std::int32_t) >= page)
    {
      EXPECT_EQ(place(values) % page, 0U);
    }
    LargeVector<std::int32_t> moved = std::move(values);
    const LargeVector<std::int32_t> copied = moved;
    EXPECT_EQ(copied.back(), static_cast<std::int32_t>(count) - 1);
    EXPECT_NE(place(copied), place(moved));
    moved.resize(2 * count); // the vector grows
    EXPECT_EQ(moved[count - 1], static_cast<std::int32_t>(count) - 1);
    EXPECT_EQ(place(moved) % 64, 0U);
  }
}
} // namespace palpate
