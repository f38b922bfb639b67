// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EntryGate_h
#define palpate_EntryGate_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * The first link: a session that begins, or goes on after a loss, with the tool inside the body
 * must not push it out with whatever force that depth has. The gate is closed until the tip has
 * been outside once. With a ramp, the first touch after that is soft: the share grows linearly from
 * 0 over so many seconds, counted from that touch.
 */
class PALPATE_EXPORT EntryGate
{
public:
  /// `ramp` in s; 0, or what is no number: none. Without `closes` the gate is always open.
  EntryGate(bool closes, double ramp) noexcept
    : Closes(closes)
    , Ramp(ramp)
  {
  }

  /// Of the force that may pass now, 0 to 1; time in s.
  double share(double time, bool outside) noexcept;
  void close() noexcept;

private:
  bool Closes;
  double Ramp;
  bool HasBeenOutside = false;
  bool HasTouched = false;
  double TouchTime = 0.0;
};
} // namespace palpate

#endif
