// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/EntryGate.h"

#include <algorithm>

namespace palpate
{
double EntryGate::share(double time, bool outside) noexcept
{
  this->HasBeenOutside = this->HasBeenOutside || outside;
  if (this->Closes && !this->HasBeenOutside)
  {
    return 0.0;
  }
  if (!this->HasTouched)
  {
    if (outside)
    {
      return 1.0; // there is no force to scale
    }
    this->HasTouched = true;
    this->TouchTime = time;
  }
  const double since = time - this->TouchTime;
  return this->Ramp > 0.0 && since < this->Ramp ? std::max(0.0, since / this->Ramp) : 1.0;
}

void EntryGate::close() noexcept
{
  this->HasBeenOutside = false;
  this->HasTouched = false;
}
} // namespace palpate
