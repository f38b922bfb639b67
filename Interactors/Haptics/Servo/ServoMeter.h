// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ServoMeter_h
#define palpate_ServoMeter_h

#include "Haptics/Servo/LatencyHistogram.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Servo/ServoStatistics.h"

#include <atomic>
#include <cstdint>

namespace palpate
{
/// Counts events in one thread for another one to read; neither ever waits.
class EventCount
{
public:
  void add(std::uint64_t events = 1) noexcept
  {
    this->Events.store(
      this->Events.load(std::memory_order_relaxed) + events, std::memory_order_release);
  }
  std::uint64_t total() const noexcept { return this->Events.load(std::memory_order_acquire); }
  /// Since the last reset; read and reset are for one thread.
  std::uint64_t read() const noexcept { return this->total() - this->Baseline; }
  void reset() noexcept { this->Baseline = this->total(); }

private:
  std::atomic<std::uint64_t> Events{ 0 };
  std::uint64_t Baseline = 0; ///< the reader's
};

/**
 * Keeps the statistics of a servo loop. The servo thread adds to it, one other thread reads and
 * resets it; neither ever waits. See LatencyHistogram for what a reading holds; counts of one
 * reading may differ by the tick that was under way.
 */
struct PALPATE_EXPORT ServoMeter
{
  LatencyHistogram period;
  LatencyHistogram wakeUp;
  LatencyHistogram tick;
  EventCount ticks;
  EventCount missed;
  EventCount invalidSamples;
  EventCount repeatedSamples;
  EventCount refusedForces;
  EventCount sceneChanges;

  /// Since the last reset; the fields of which the meter knows nothing are left alone.
  void read(ServoStatistics& statistics) const noexcept;
  void reset() noexcept;
};
} // namespace palpate

#endif
