// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltNeed_h
#define palpate_TiltNeed_h

#include "Contact/ResponseField.h"
#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
/// What a tolerance needs of the tilts of a response.
struct TiltNeed
{
  double change = 0.0;  ///< of the force, relative: the largest by any tilt
  double angle = 0.0;   ///< rad, at which it is so large
  double without = 0.0; ///< of the points: those where no tilt changes it by more
  double torque = 0.0;  ///< the largest there is, N mm
  bool isFelt = false;  ///< somewhere by more than the tolerance
};

/**
 * By how much a tilt changes the force, the tip being as deep: at half of each point's range, over
 * eight tilts up to the largest. A tool whose end is flat or round goes deeper beside its tip as it
 * is tilted about it, which is in the change. Of up to 4096 points evenly taken.
 */
PALPATE_EXPORT TiltNeed tiltNeed(const ResponseArrays& arrays, double tolerance);

/// The need in a sentence without its stop; "" of a response that knows of no tilts.
PALPATE_EXPORT std::string tiltReason(
  const TiltNeed& need, const TiltViews& tilts, double tolerance);
} // namespace palpate

#endif
