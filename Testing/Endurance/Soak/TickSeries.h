// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_TickSeries_h
#define palpate_endurance_TickSeries_h

#include "SceneSupply.h"
#include "TickChecker.h"

#include "Haptics/Devices/WorkspaceMapping.h"
#include "Haptics/Safety/SafetySettings.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::endurance
{
/**
 * Two seconds of ticks of the real servo step, in virtual time, with two scenes. A checker must
 * accept these ticks; a test introduces faults into them. The tip moves into the body and out three
 * times. A swap and three losses happen during contact.
 */
class TickSeries
{
public:
  static constexpr double Rate = 4000.0; ///< Hz
  static constexpr std::size_t Length = 8000;
  static constexpr std::size_t Swap = 2400;
  static constexpr std::size_t Ramp = 200;    ///< number of ticks that a swap takes
  static constexpr std::size_t Absent = 3600; ///< first of Gap ticks without a sample
  static constexpr std::size_t Silent = 5600; ///< first of Gap ticks without a new sample
  static constexpr std::size_t Broken = 7000; ///< tick with one NaN
  static constexpr std::size_t Gap = 100;     ///< 25 ms, longer than the time-out

  /// The frame of the device.
  static DeviceFrame frame();
  static WorkspaceMapping mapping();
  static SafetySettings safety();

  /// Without `swaps` the first scene stays in contact. A non-negative `friction` applies to both
  /// scenes. With the relaxing body and without swaps there are no losses, so its visits are
  /// complete.
  explicit TickSeries(unsigned seed, bool swaps = true, double friction = -1.0, double begin = 0.0,
    Supplied bodies = Supplied::Elastic);

  /// Changes the sent force and its record.
  void send(std::size_t tick, const Vector3& force)
  {
    this->ticks[tick].sent = force;
    this->ticks[tick].saidSent = force;
  }
  /// Returns true if the force of a tick differs enough from the previous tick's force to be
  /// distinguished.
  bool moves(std::size_t tick) const;

  struct Finding
  {
    TickFault fault = TickFault::None;
    std::size_t tick = 0;
    std::string text;
  };
  /// Returns the first fault.
  Finding firstFault() const;
  /// Returns the counts over all ticks.
  TickTally tally() const;

  std::vector<TickFacts> ticks;

private:
  SceneSupply Supply;
  SuppliedScene First;
  SuppliedScene Second;
};
} // namespace palpate::endurance

#endif
