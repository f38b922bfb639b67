// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_LossRule_h
#define palpate_endurance_LossRule_h

#include "Haptics/Devices/HapticDevice.h"

namespace palpate::endurance
{
/// Decides in which ticks there must be no force, independent of the body in contact. There is no
/// force without a valid position, or if the last new sample is older than the time-out. If one of
/// these conditions lasts longer than the time-out, the force stays off until the tip has been
/// outside.
class LossRule
{
public:
  /// `timeOut` in s.
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

  /// Returns true for a lost tick if the last new sample is not older than the time-out.
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
