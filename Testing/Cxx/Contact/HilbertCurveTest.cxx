// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/HilbertCurve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
using Cell = std::array<std::uint32_t, 3>;

/// The cells of a cube of `side`³ with its low corner at `corner`, in the order of their keys.
std::vector<std::pair<std::uint64_t, Cell>> alongCurve(std::uint32_t side, const Cell& corner)
{
  std::vector<std::pair<std::uint64_t, Cell>> cells;
  for (std::uint32_t x = 0; x < side; ++x)
  {
    for (std::uint32_t y = 0; y < side; ++y)
    {
      for (std::uint32_t z = 0; z < side; ++z)
      {
        const Cell cell{ corner[0] + x, corner[1] + y, corner[2] + z };
        cells.emplace_back(hilbertKey(cell), cell);
      }
    }
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

int stepsApart(const Cell& a, const Cell& b)
{
  int steps = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    steps += std::abs(static_cast<int>(a[k]) - static_cast<int>(b[k]));
  }
  return steps;
}

/// Expects that an aligned cube whose side is a power of two has consecutive keys, and that each
/// cell is next to the previous one.
void expectOneStretch(std::uint32_t side, const Cell& corner)
{
  const auto cells = alongCurve(side, corner);
  for (std::size_t i = 1; i < cells.size(); ++i)
  {
    ASSERT_EQ(cells[i].first, cells[i - 1].first + 1);
    ASSERT_EQ(stepsApart(cells[i].second, cells[i - 1].second), 1);
  }
}
} // namespace

TEST(HilbertCurve, GoesThroughEachCellOnceStepByStep)
{
  const auto cells = alongCurve(8, { 0, 0, 0 });
  EXPECT_EQ(cells.front().first, 0U);
  EXPECT_EQ(cells.back().first, 8U * 8 * 8 - 1);
  expectOneStretch(8, { 0, 0, 0 });
  expectOneStretch(32, { 0, 0, 0 });
}

TEST(HilbertCurve, EveryAlignedCubeIsOneStretch)
{
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i)
  {
    const std::uint32_t side = 1U << (1 + random() % 3);
    const auto start = [&] { return static_cast<std::uint32_t>(random() % (65536 / side)) * side; };
    const std::uint32_t x = start();
    const std::uint32_t y = start();
    expectOneStretch(side, { x, y, start() });
  }
}

TEST(HilbertCurve, EndsAtTheFarEndOfOneAxis)
{
  // The curve leads from one corner of the cube of 2^48 cells to an adjacent corner.
  const std::uint32_t far = 65535;
  std::vector<std::uint64_t> keys;
  for (const Cell& corner : { Cell{ far, 0, 0 }, Cell{ 0, far, 0 }, Cell{ 0, 0, far },
         Cell{ far, far, 0 }, Cell{ far, 0, far }, Cell{ 0, far, far }, Cell{ far, far, far } })
  {
    keys.push_back(hilbertKey(corner));
  }
  EXPECT_EQ(hilbertKey({ 0, 0, 0 }), 0U);
  EXPECT_EQ(*std::max_element(keys.begin(), keys.end()), (std::uint64_t{ 1 } << 48) - 1);
  // one of the corners on an axis
  EXPECT_LT(std::max_element(keys.begin(), keys.end()) - keys.begin(), 3);
}
} // namespace palpate
