// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_TickSeries_h
#define palpate_endurance_TickSeries_h

#include "SceneSupply.h"
#include "TickChecker.h"

#include "Haptics/Safety/SafetySettings.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::endurance
{
/**
 * Two seconds of ticks of the real servo step, in virtual time, over two scenes: what a checker
 * must accept, and what a test spoils. In and out of the body three times, with a swap and three
 * losses while in contact.
 */
class TickSeries
{
public:
  static constexpr double Rate = 4000.0; ///< Hz
  static constexpr std::size_t Length = 8000;
  static constexpr std::size_t Swap = 2400;
  static constexpr std::size_t Ramp = 200;    ///< ticks that a swap takes
  static constexpr std::size_t Absent = 3600; ///< no sample for Gap ticks
  static constexpr std::size_t Silent = 5600; ///< nothing new for Gap ticks
  static constexpr std::size_t Broken = 7000; ///< one NaN
  static constexpr std::size_t Gap = 100;     ///< 25 ms, longer than the time-out

  /// Of the device.
  static DeviceFrame frame();
  static SafetySettings safety();

  /// Of the body that relaxes, without swaps, there are no losses either: its visits are whole.
  /// Without `swaps` the first scene is felt throughout; a `friction` of its own for both scenes,
  /// if it is not negative.
  explicit TickSeries(unsigned seed, bool swaps = true, double friction = -1.0, double begin = 0.0,
    Supplied bodies = Supplied::Elastic);

  /// Sent, and said so.
  void send(std::size_t tick, const Vector3& force)
  {
    this->ticks[tick].sent = force;
    this->ticks[tick].saidSent = force;
  }
  /// Whether the force of a tick is so far from that of the one before that it can be told.
  bool moves(std::size_t tick) const;

  struct Finding
  {
    TickFault fault = TickFault::None;
    std::size_t tick = 0;
    std::string text;
  };
  /// The first fault, from the beginning.
  Finding firstFault() const;
  /// Of all ticks.
  TickTally tally() const;

  std::vector<TickFacts> ticks;

private:
  SceneSupply Supply;
  SuppliedScene First;
  SuppliedScene Second;
};
} // namespace palpate::endurance

#endif
