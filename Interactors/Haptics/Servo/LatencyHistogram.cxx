// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/LatencyHistogram.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate
{
namespace
{
constexpr int ClassBits = 5; // 32 classes per doubling
constexpr std::size_t ClassesPerDoubling = std::size_t{ 1 } << ClassBits;
} // namespace

std::size_t LatencyCounts::classOf(std::int64_t nanoseconds) noexcept
{
  const auto value = static_cast<std::uint64_t>(std::max<std::int64_t>(nanoseconds, 0));
  if (value < ClassesPerDoubling)
  {
    return static_cast<std::size_t>(value);
  }
  // The conversion to double may round the value, but only for values beyond the last class.
  const int shift = std::ilogb(static_cast<double>(value)) - ClassBits;
  const std::size_t index =
    static_cast<std::size_t>(shift) * ClassesPerDoubling + static_cast<std::size_t>(value >> shift);
  return std::min(index, Classes - 1);
}

std::int64_t LatencyCounts::longestOf(std::size_t index) noexcept
{
  if (index < 2 * ClassesPerDoubling)
  {
    return static_cast<std::int64_t>(index);
  }
  const std::size_t shift = index / ClassesPerDoubling - 1;
  const std::size_t leading = index - shift * ClassesPerDoubling;
  return static_cast<std::int64_t>(((leading + 1) << shift) - 1);
}

std::uint64_t LatencyCounts::total() const noexcept
{
  return std::accumulate(this->Counts.begin(), this->Counts.end(), std::uint64_t{ 0 });
}

std::int64_t LatencyCounts::quantile(double share) const noexcept
{
  const std::uint64_t all = this->total();
  if (all == 0)
  {
    return 0;
  }
  const double rank = std::ceil(share * static_cast<double>(all));
  const auto wanted = static_cast<std::uint64_t>(std::max(rank, 1.0));
  std::uint64_t passed = 0;
  for (std::size_t i = 0; i < Classes - 1; ++i)
  {
    passed += this->Counts[i];
    if (passed >= wanted)
    {
      return std::min(longestOf(i), this->Worst);
    }
  }
  return this->Worst;
}

LatencyCounts LatencyCounts::since(
  const LatencyCounts& earlier, std::int64_t worstSince) const noexcept
{
  LatencyCounts difference;
  for (std::size_t i = 0; i < Classes; ++i)
  {
    difference.Counts[i] = this->Counts[i] - earlier.Counts[i];
  }
  difference.Worst = worstSince;
  difference.fitWorst();
  return difference;
}

void LatencyCounts::fitWorst() noexcept
{
  std::size_t last = Classes;
  while (last > 0 && this->Counts[last - 1] == 0)
  {
    --last;
  }
  if (last == 0)
  {
    this->Worst = 0;
  }
  else if (classOf(this->Worst) != last - 1)
  {
    // The longest duration was added or reset during the reading of the counts.
    this->Worst = longestOf(last - 1);
  }
}

LatencyCounts LatencyHistogram::readAll() const noexcept
{
  LatencyCounts counts;
  for (std::size_t i = 0; i < LatencyCounts::Classes; ++i)
  {
    counts.Counts[i] = this->Counts[i].load(std::memory_order_acquire);
  }
  return counts;
}

LatencyCounts LatencyHistogram::read() const noexcept
{
  const LatencyCounts counts = this->readAll();
  return counts.since(this->Baseline, this->Worst.load(std::memory_order_relaxed));
}

void LatencyHistogram::reset() noexcept
{
  this->Worst.store(0, std::memory_order_relaxed);
  this->Baseline = this->readAll();
}
} // namespace palpate
