// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DeviceFaults_h
#define palpate_DeviceFaults_h

#include "Mechanics/PalpateExport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{
/// Faults of a device in order of severity. If several faults are due at once, the most severe one
/// occurs.
enum class DeviceFault : std::uint8_t
{
  NotANumber, ///< a reading's position and velocity are NaN, but it is marked valid
  Repeated,   ///< a reading repeats the last one, but is marked new
  Dropped,    ///< a reading is lost; the last one is repeated and marked as not fresh
  Late,       ///< a reading arrives later, replaces the readings due until then, and is marked new
  Stall,      ///< the device hangs; no reading is fresh, and the last force continues
  Disconnect  ///< no reading is valid, no force is accepted, and no force acts on the hand
};
constexpr std::size_t DeviceFaultCount = 6;

/// One fault at a given time.
struct ScheduledFault
{
  DeviceFault fault = DeviceFault::Dropped;
  double start = 0.0; ///< s
  /// Duration, s. The fault affects every reading with start <= time < start + duration, and at
  /// least the first reading at or after its start. For Late, the duration is the delay of the
  /// first late reading.
  double duration = 0.0;
};

/// Random faults, reproducible by the seed.
struct FaultRate
{
  double probability = 0.0; ///< s, as in ScheduledFault
  double duration = 0.0;    ///< s, as in ScheduledFault
};

/// The faults of a FaultyDevice, by schedule and at random.
struct DeviceFaults
{
  std::vector<ScheduledFault> schedule; ///< faults at given times, in any order
  /// Indexed by fault, for example rates[size_t(DeviceFault::Late)].
  std::array<FaultRate, DeviceFaultCount> rates;
  std::uint64_t seed = 1;

  FaultRate& rate(DeviceFault fault) { return this->rates[static_cast<std::size_t>(fault)]; }
};

/// Describes the first number that is out of its range, with the name of the device fault. Returns
/// "" if there is none.
PALPATE_EXPORT std::string fault(const DeviceFaults& faults);
} // namespace palpate

#endif
