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
 * How often durations of each length were met, and the longest. Nanoseconds.
 *
 * Classes are 1 ns wide up to 64 ns, then 32 to each doubling: at most 1/32 of what they hold. The
 * last one takes everything from 68 s on.
 */
class PALPATE_EXPORT LatencyCounts
{
public:
  static constexpr std::size_t Classes = 1024;

  /// The class a duration belongs to; a negative one belongs to 0 ns.
  static std::size_t classOf(std::int64_t nanoseconds) noexcept;
  /// The longest duration of a class.
  static std::int64_t longestOf(std::size_t index) noexcept;

  /// How many durations a class holds.
  std::uint64_t count(std::size_t index) const noexcept { return this->Counts[index]; }
  std::uint64_t total() const noexcept;
  /// The least duration that `share` (0 to 1) of all do not exceed: never less than the true one,
  /// and less than 1/32 more. 0 if there is none.
  std::int64_t quantile(double share) const noexcept;
  /// The longest, exactly. 0 if there is none.
  std::int64_t worst() const noexcept { return this->Worst; }

  /// What came after `earlier`, an earlier reading of the same histogram. `worstSince` is the
  /// longest of it as far as it is known; it is never reported shorter than its class.
  LatencyCounts since(const LatencyCounts& earlier, std::int64_t worstSince) const noexcept;

private:
  friend class LatencyHistogram;
  void fitWorst() noexcept;

  std::array<std::uint64_t, Classes> Counts{};
  std::int64_t Worst = 0;
};

/**
 * Counts durations in one thread while another one reads; neither ever waits.
 *
 * add is for one thread: two relaxed stores, no read-modify-write. read and reset are for one other
 * thread. Each class only grows, and a reader never sees it smaller than before: of two readings
 * the later holds all of the earlier. A reading may lack the durations that were added during it,
 * but its total and quantiles are those of one set of counts, and worst() is none that it lacks the
 * class of. reset leaves the counts alone and remembers them, so that the other thread has nothing
 * to do for it.
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

  /// Since the last reset.
  LatencyCounts read() const noexcept;
  void reset() noexcept;

private:
  LatencyCounts readAll() const noexcept;

  std::array<std::atomic<std::uint64_t>, LatencyCounts::Classes> Counts{};
  std::atomic<std::int64_t> Worst{ 0 };
  LatencyCounts Baseline; ///< the reader's
};
} // namespace palpate

#endif
