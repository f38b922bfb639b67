// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_SoakResult_h
#define palpate_endurance_SoakResult_h

#include "MemoryWatch.h"
#include "TickChecker.h"
#include "UnsteadyDevice.h"

#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace palpate::endurance
{
/// Counts and findings of a soak.
struct SoakResult
{
  double seconds = 0.0;
  double rate = 0.0;
  std::string granted; ///< scheduling that the system granted the servo thread
  std::uint64_t ticks = 0;
  std::uint64_t missed = 0;   ///< ticks missed because the machine was too busy
  std::uint64_t overruns = 0; ///< ticks that were not drained in time
  TickTally tally;
  std::vector<std::string> faults; ///< the first faults, as text
  std::uint64_t swapsAsked = 0;
  std::uint64_t swapsSeen = 0;
  std::uint64_t swapsLate = 0;   ///< swaps not in the next possible tick
  std::uint64_t bodiesKept = 0;  ///< bodies that should have been freed before the next swap
  std::uint64_t bodiesAlive = 0; ///< number of bodies after the end
  bool isForceLeft = false;      ///< whether a force is left on the device after the end
  DeviceTroubles troubles;
  bool isDrawn = false;
  std::uint64_t frames = 0;
  MemoryWatch::Course resident;
  MemoryWatch::Course heap;
  std::array<double, 3> wakeUp{}; ///< wake-up delay: median, 99 %, longest; µs

  /// The requirements that are not met, one line each; empty if all are met.
  std::vector<std::string> complaints() const;
  void print(std::ostream& out) const;
  void writeJson(std::ostream& out) const;
};
} // namespace palpate::endurance

#endif
