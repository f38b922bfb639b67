// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LatencyHistogram_h
#define palpate_LatencyHistogram_h

#include "Mechanics/PalpateExport.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/**
 * Counts of durations by length, and the longest duration. In nanoseconds.
 *
 * Classes are 1 ns wide up to 64 ns. From there each doubling has 32 classes, so that a class is at
 * most 1/32 as wide as the durations in it are long. The last class takes everything from 68 s on.
 */
class PALPATE_EXPORT LatencyCounts
{
public:
  static constexpr std::size_t Classes = 1024;

  /// The class of a duration; a negative duration counts as 0 ns.
  static std::size_t classOf(std::int64_t nanoseconds) noexcept;
  /// The longest duration of a class.
  static std::int64_t longestOf(std::size_t index) noexcept;

  /// Number of durations in a class.
  std::uint64_t count(std::size_t index) const noexcept { return this->Counts[index]; }
  std::uint64_t total() const noexcept;
  /// The least duration that `share` (0 to 1) of all durations do not exceed. It is never below the
  /// true value, and less than 1/32 above it. 0 if there is no duration.
  std::int64_t quantile(double share) const noexcept;
  /// The longest duration, exactly. 0 if there is none.
  std::int64_t worst() const noexcept { return this->Worst; }

  /// The durations counted after `earlier`, an earlier reading of the same histogram. `worstSince`
  /// is the longest of them, as far as it is known. If `worstSince` is not in the highest class
  /// that has a count, the upper end of that class is reported instead.
  LatencyCounts since(const LatencyCounts& earlier, std::int64_t worstSince) const noexcept;

private:
  friend class LatencyHistogram;
  void fitWorst() noexcept;

  std::array<std::uint64_t, Classes> Counts{};
  std::int64_t Worst = 0;
};

/**
 * Counts durations in one thread while another thread reads. Neither thread ever waits.
 *
 * add is for one thread: at most two stores, no read-modify-write. read and reset are for one other
 * thread. The count of a class only grows, and a reader never sees it smaller than before: a later
 * reading contains all of an earlier one. A reading may lack durations that were added during it.
 * Its total and quantiles are still those of one set of counts, and worst() always belongs to a
 * class that has a count. reset does not change the counts: it stores them as a baseline, so that
 * the counting thread has nothing to do for it.
 */
class PALPATE_EXPORT LatencyHistogram
{
public:
  void add(std::int64_t nanoseconds) noexcept
  {
    if (nanoseconds > this->Worst.load(std::memory_order_relaxed))
    {
      this->Worst.store(nanoseconds, std::memory_order_relaxed);
    }
    std::atomic<std::uint64_t>& count = this->Counts[LatencyCounts::classOf(nanoseconds)];
    count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }

  /// The durations since the last reset.
  LatencyCounts read() const noexcept;
  void reset() noexcept;

private:
  LatencyCounts readAll() const noexcept;

  std::array<std::atomic<std::uint64_t>, LatencyCounts::Classes> Counts{};
  std::atomic<std::int64_t> Worst{ 0 };
  LatencyCounts Baseline; ///< the counts at the last reset; used by the reading thread only
};
} // namespace palpate

#endif
