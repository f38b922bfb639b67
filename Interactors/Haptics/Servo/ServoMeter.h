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
/// Timing and errors of a servo loop since its construction or the last reset.
struct PALPATE_EXPORT ServoStatistics
{
  double rate = 0.0;   ///< requested ticks per second
  RealTimeGrant grant; ///< grant of the last start

  std::uint64_t ticks = 0;
  /// Ticks that were skipped because they could not begin within their period.
  std::uint64_t missed = 0;
  std::uint64_t invalidSamples = 0;  ///< ticks in which the device had no valid sample
  std::uint64_t repeatedSamples = 0; ///< ticks whose valid sample was not new
  std::uint64_t refusedForces = 0;   ///< ticks whose force the device did not accept
  std::uint64_t overruns = 0;        ///< ticks for which the recording had no space
  std::uint64_t sceneChanges = 0;    ///< number of scenes that were taken
  DeviceErrors device;               ///< the counts of the device

  LatencyCounts period; ///< time from the beginning of a tick to that of the next tick
  LatencyCounts wakeUp; ///< time from a tick's deadline to its beginning
  LatencyCounts tick;   ///< time from a tick's beginning until its force is sent and published

  /// A few lines of text: counts, and median, 99 %, 99.9 % and worst of the three times in µs.
  std::string describe() const;
};

/// Counts events in one thread while another thread reads. Neither thread ever waits.
class EventCount
{
public:
  void add(std::uint64_t events = 1) noexcept
  {
    this->Events.store(
      this->Events.load(std::memory_order_relaxed) + events, std::memory_order_release);
  }
  std::uint64_t total() const noexcept { return this->Events.load(std::memory_order_acquire); }
  /// Events since the last reset; read and reset are for one thread.
  std::uint64_t read() const noexcept { return this->total() - this->Baseline; }
  void reset() noexcept { this->Baseline = this->total(); }

private:
  std::atomic<std::uint64_t> Events{ 0 };
  std::uint64_t Baseline = 0; ///< the total at the last reset; used by the reading thread only
};

/**
 * The statistics of a servo loop. The servo thread adds to them, one other thread reads and resets
 * them; neither ever waits. LatencyHistogram describes how exact a reading is; the counts of one
 * reading may differ by the present tick.
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

  /// Writes the statistics since the last reset; fields that are not measured by this class are
  /// unchanged.
  void read(ServoStatistics& statistics) const noexcept;
  void reset() noexcept;
};
} // namespace palpate

#endif
