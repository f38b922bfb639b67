// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/SampleWatchdog.h"

namespace palpate
{
bool SampleWatchdog::isLost(double time, bool fresh) noexcept
{
  if (!this->HasTime)
  {
    this->HasTime = true;
    this->LastTime = time;
    this->LastFresh = time;
  }
  const bool wentBack = time < this->LastTime;
  if (wentBack)
  {
    this->LastFresh = time; // of the new clock
  }
  const bool isOld = !(time - this->LastFresh <= this->TimeOut);
  this->LastTime = time;
  if (fresh)
  {
    this->LastFresh = time;
  }
  return wentBack || isOld;
}
} // namespace palpate
