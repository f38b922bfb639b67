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
 * Counts durations by length and stores the longest duration. Durations are in nanoseconds.
 *
 * Classes are 1 ns wide up to 64 ns. Above 64 ns, each doubling of the duration has 32 classes, so
 * that the width of a class is at most 1/32 of the durations in it. The last class contains all
 * durations of 68 s and more.
 */
class PALPATE_EXPORT LatencyCounts
{
public:
  static constexpr std::size_t Classes = 1024;

  /// The index of a duration's class. A negative duration counts as 0 ns.
  static std::size_t classOf(std::int64_t nanoseconds) noexcept;
  /// The longest duration of a class.
  static std::int64_t longestOf(std::size_t index) noexcept;

  /// Number of durations in a class.
  std::uint64_t count(std::size_t index) const noexcept { return this->Counts[index]; }
  std::uint64_t total() const noexcept;
  /// The smallest duration that a fraction `share` (0 to 1) of all durations does not exceed. The
  /// result is not below the true value, and exceeds it by less than 1/32. It is 0 if there is no
  /// duration.
  std::int64_t quantile(double share) const noexcept;
  /// The exact longest duration; 0 if there is none.
  std::int64_t worst() const noexcept { return this->Worst; }

  /// The durations that were counted after `earlier`, an earlier reading of the same histogram.
  /// `worstSince` is the longest of these durations, if it is known. If `worstSince` is not in the
  /// highest class with a count, the upper end of that class is used instead.
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
 * One thread calls add, which makes at most two stores and no read-modify-write. One other thread
 * calls read and reset. The count of a class only grows, and a reader never sees it decrease: a
 * later reading contains all durations of an earlier one. A reading may lack durations that were
 * added during the reading. The total and the quantiles of a reading nevertheless belong to one set
 * of counts, and worst() always belongs to a class with a count. reset does not change the counts:
 * it stores them as a baseline, so that the counting thread is not involved.
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
  LatencyCounts Baseline; ///< the counts at the last reset, used only by the reading thread
};
} // namespace palpate

#endif
