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
/// Faults of a device, the gravest last; the gravest of several occurs.
enum class DeviceFault : std::uint8_t
{
  NotANumber, ///< a reading's position and velocity are NaN, and it claims to be valid
  Repeated,   ///< a reading repeats the one before, and claims to be new
  Dropped,    ///< a reading is lost: the one before is repeated, not fresh
  Late,       ///< a reading arrives later, in place of those due until then; it claims to be new
  Stall,      ///< the device hangs: nothing fresh is read, and the last force continues
  Disconnect  ///< nothing valid is read, no force is accepted, and none acts on the hand
};
constexpr std::size_t DeviceFaultCount = 6;

/// One fault at a given time.
struct ScheduledFault
{
  DeviceFault fault = DeviceFault::Dropped;
  double start = 0.0; ///< s
  /// s. It affects every reading of start <= time < start + duration, and in any case the first at
  /// or after its start. For Late: the delay of the first one.
  double duration = 0.0;
};

/// Faults at random, the same for the same seed.
struct FaultRate
{
  double probability = 0.0; ///< of beginning at a given reading, 0 to 1
  double duration = 0.0;    ///< s, as in ScheduledFault
};

/// The faults of a FaultyDevice, by schedule and at random.
struct DeviceFaults
{
  std::vector<ScheduledFault> schedule; ///< in any order
  /// By fault: rates[size_t(DeviceFault::Late)].
  std::array<FaultRate, DeviceFaultCount> rates;
  std::uint64_t seed = 1;

  FaultRate& rate(DeviceFault fault) { return this->rates[static_cast<std::size_t>(fault)]; }
};

/// What is wrong with the numbers, naming the fault; or "".
PALPATE_EXPORT std::string fault(const DeviceFaults& faults);
} // namespace palpate

#endif
