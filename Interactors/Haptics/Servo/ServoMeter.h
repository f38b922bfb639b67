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
  /// Number of ticks that were skipped because they could not begin within their period.
  std::uint64_t missed = 0;
  std::uint64_t invalidSamples = 0;  ///< ticks in which the device had no valid sample
  std::uint64_t repeatedSamples = 0; ///< ticks whose valid sample was not new
  std::uint64_t refusedForces = 0;   ///< ticks whose force the device did not accept
  std::uint64_t overruns = 0;        ///< ticks for which the recording had no space
  std::uint64_t sceneChanges = 0;    ///< number of scenes that the servo thread has taken
  DeviceErrors device;               ///< error counts of the device

  LatencyCounts period; ///< time from the beginning of a tick to that of the next tick
  LatencyCounts wakeUp; ///< time from a tick's deadline to its beginning
  LatencyCounts tick;   ///< time from a tick's beginning until its force is sent and published

  /// A few lines of text with the counts, and with the median, the 99 % and 99.9 % quantiles and
  /// the maximum of the three times, µs.
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
  /// Number of events since the last reset. read and reset are for one thread.
  std::uint64_t read() const noexcept { return this->total() - this->Baseline; }
  void reset() noexcept { this->Baseline = this->total(); }

private:
  std::atomic<std::uint64_t> Events{ 0 };
  std::uint64_t Baseline = 0; ///< the total at the last reset, used only by the reading thread
};

/**
 * The statistics of a servo loop. The servo thread adds to the statistics, and one other thread
 * reads and resets them. Neither thread ever waits. LatencyHistogram documents the accuracy of a
 * reading. The counts of one reading may differ from one another by the present tick.
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

  /// Writes the statistics since the last reset to `statistics`. Fields that this class does not
  /// measure are unchanged.
  void read(ServoStatistics& statistics) const noexcept;
  void reset() noexcept;
};
} // namespace palpate

#endif
