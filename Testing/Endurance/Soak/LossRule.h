// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_LossRule_h
#define palpate_endurance_LossRule_h

#include "Haptics/Devices/HapticDevice.h"

namespace palpate::endurance
{
/// In which ticks there must be no force, whatever is felt: without a place to feel it at, and when
/// nothing new has come for longer than the time-out. After that, or longer without a place, not
/// until the tip was outside.
class LossRule
{
public:
  /// s
  explicit LossRule(double timeOut)
    : TimeOut(timeOut)
  {
  }

  static bool isPlaced(const DeviceSample& sample)
  {
    return sample.valid && sample.position.allFinite();
  }

  bool isLost(const DeviceSample& sample, double time)
  {
    if (!isPlaced(sample))
    {
      return true;
    }
    const bool isOld = this->HasHeard && time - this->LastNew > this->TimeOut;
    if (sample.fresh || !this->HasHeard)
    {
      this->LastNew = time;
    }
    this->HasHeard = true;
    return isOld;
  }

  /// Of a tick that is lost: the last new place is no older than the time-out.
  bool isGap(const DeviceSample& sample, double time) const
  {
    return !isPlaced(sample) && this->HasHeard && time - this->LastNew <= this->TimeOut;
  }

private:
  double TimeOut;
  bool HasHeard = false;
  double LastNew = 0.0;
};
} // namespace palpate::endurance

#endif
