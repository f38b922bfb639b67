// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SampleWatchdog_h
#define palpate_SampleWatchdog_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Whether the device still tells where the hand is: one that has told nothing new for longer than
 * its time-out is lost, until it does. The same holds for a loop that has not asked for so long,
 * and for a clock that goes back.
 */
class PALPATE_EXPORT SampleWatchdog
{
public:
  /// `timeOut` in s; infinite: never; negative or NaN: always.
  explicit SampleWatchdog(double timeOut) noexcept
    : TimeOut(timeOut)
  {
  }

  /// Called in every tick with a valid sample; `fresh`: it is a new one. True: no force now.
  bool isLost(double time, bool fresh) noexcept;
  /// The time-out begins with the next call.
  void reset() noexcept { this->HasTime = false; }

private:
  double TimeOut;
  bool HasTime = false;
  double LastTime = 0.0;  ///< of the last call
  double LastFresh = 0.0; ///< of the last new sample
};
} // namespace palpate

#endif
