// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/HilbertCurve.h"

#include "Contact/ParallelRanges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr unsigned Bits = 16;

/// Moves the 16 bits of x to every third bit of the result.
std::uint64_t spread(std::uint64_t x) noexcept
{
  x = (x | (x << 32)) & 0x00FF00000000FFFFULL;
  x = (x | (x << 16)) & 0x00FF0000FF0000FFULL;
  x = (x | (x << 8)) & 0xF00F00F00F00F00FULL;
  x = (x | (x << 4)) & 0x30C30C30C30C30C3ULL;
  x = (x | (x << 2)) & 0x9249249249249249ULL;
  return x;
}
constexpr double LastCell = (1U << Bits) - 1;

/// Sorts one block per core, then merges the blocks. The result does not depend on the number of
/// cores.
template <class Item>
void sortInBlocks(std::vector<Item>& items)
{
  const std::size_t blocks = rangeCount(items.size());
  const auto start = [&](std::size_t k)
  { return items.begin() + static_cast<std::ptrdiff_t>(k * items.size() / blocks); };
  forRanges(items.size(),
    [&](std::size_t first, std::size_t last)
    {
      std::sort(items.begin() + static_cast<std::ptrdiff_t>(first),
        items.begin() + static_cast<std::ptrdiff_t>(last));
    });
  for (std::size_t k = 1; k < blocks; ++k)
  {
    std::inplace_merge(items.begin(), start(k), start(k + 1));
  }
}

Eigen::Vector3d centroid(const std::int32_t* corner, const float* coordinates)
{
  const auto at = [coordinates](std::int32_t point)
  { return Eigen::Map<const Eigen::Vector3f>(coordinates + 3 * static_cast<std::size_t>(point)); };
  return (at(corner[0]).cast<double>() + at(corner[1]).cast<double>() +
           at(corner[2]).cast<double>()) /
    3.0;
}
} // namespace

std::uint64_t hilbertKey(std::array<std::uint32_t, 3> cell) noexcept
{
  // Processes the bits from the highest to the second lowest: the lower bits are inverted or
  // exchanged.
  for (std::uint32_t bit = 1U << (Bits - 1); bit > 1; bit >>= 1)
  {
    const std::uint32_t lower = bit - 1;
    for (std::uint32_t& coordinate : cell)
    {
      const std::uint32_t exchanged = (cell[0] ^ coordinate) & lower;
      const std::uint32_t inverted = coordinate & bit ? ~std::uint32_t{ 0 } : 0;
      cell[0] ^= (lower & inverted) | (exchanged & ~inverted);
      coordinate ^= exchanged & ~inverted;
    }
  }
  // Converts to Gray code.
  cell[1] ^= cell[0];
  cell[2] ^= cell[1];
  std::uint32_t flips = 0;
  for (std::uint32_t bit = 1U << (Bits - 1); bit > 1; bit >>= 1)
  {
    flips ^= cell[2] & bit ? bit - 1 : 0;
  }
  return spread(cell[0] ^ flips) << 2 | spread(cell[1] ^ flips) << 1 | spread(cell[2] ^ flips);
}

void sortAlongCurve(
  std::vector<std::int32_t>& triangles, const std::int32_t* corners, const float* coordinates)
{
  const auto placeOf = [&](std::size_t i)
  { return centroid(corners + 3 * static_cast<std::size_t>(triangles[i]), coordinates); };
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    box.extend(placeOf(i));
  }
  if (triangles.empty())
  {
    return;
  }
  // The minimum keeps the scale finite if all triangles are at one point, and avoids 0 times
  // infinity.
  const double scale =
    std::min(LastCell / box.sizes().maxCoeff(), std::numeric_limits<double>::max());
  std::vector<std::pair<std::uint64_t, std::int32_t>> keyed(triangles.size());
  forRanges(triangles.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const Eigen::Vector3d position = scale * (placeOf(i) - box.min());
        std::array<std::uint32_t, 3> cell;
        for (std::size_t k = 0; k < 3; ++k)
        {
          cell[k] = static_cast<std::uint32_t>(
            std::clamp(position[static_cast<Eigen::Index>(k)], 0.0, LastCell));
        }
        keyed[i] = { hilbertKey(cell), triangles[i] };
      }
    });
  sortInBlocks(keyed);
  std::transform(keyed.begin(), keyed.end(), triangles.begin(),
    [](const std::pair<std::uint64_t, std::int32_t>& item) { return item.second; });
}
} // namespace palpate
