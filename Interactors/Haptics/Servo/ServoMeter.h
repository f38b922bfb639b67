// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ServoMeter_h
#define palpate_ServoMeter_h

#include "Haptics/Devices/HapticDevice.h"
#include "Haptics/Servo/LatencyHistogram.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Servo/RealTimeGrant.h"

#include <atomic>
#include <cstdint>
#include <string>

namespace palpate
{
/// How a servo loop has kept time, and what went wrong, since it was made or last reset.
struct PALPATE_EXPORT ServoStatistics
{
  double rate = 0.0;   ///< ticks per second that were asked for
  RealTimeGrant grant; ///< of the newest start

  std::uint64_t ticks = 0;
  std::uint64_t missed = 0;         ///< ticks whose whole period had passed before they could begin
  std::uint64_t invalidSamples = 0; ///< ticks in which the device had nothing valid to say
  std::uint64_t repeatedSamples = 0; ///< ticks in which it had nothing new to say
  std::uint64_t refusedForces = 0;   ///< ticks whose force the device did not take
  std::uint64_t overruns = 0;        ///< ticks that the recording had no room for
  std::uint64_t sceneChanges = 0;    ///< scenes that were taken over
  DeviceErrors device;               ///< the device's own counts

  LatencyCounts period; ///< from one tick's beginning to the next one's
  LatencyCounts wakeUp; ///< from a tick's deadline to its beginning
  LatencyCounts tick;   ///< from a tick's beginning to the force written and the tick published

  /// Some lines for a person: counts, and median, 99 %, 99.9 % and worst of the three times in µs.
  std::string describe() const;
};

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
