// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltNeed_h
#define palpate_TiltNeed_h

#include "Contact/ResponseField.h"
#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
/// Whether a tolerance needs the tilts of a response.
struct TiltNeed
{
  double change = 0.0; ///< of the force, relative: the largest by any tilt
  double angle = 0.0;  ///< rad, at which it is largest
  /// Fraction of the points where no tilt changes it by more than the tolerance.
  double without = 0.0;
  double torque = 0.0; ///< the largest, N mm
  bool isFelt = false; ///< the change exceeds the tolerance somewhere
};

/**
 * The change of the force by a tilt at equal depth of the tip: at half of each point's range, over
 * eight tilts up to the largest. It includes that a tool with a flat or round end, tilted about its
 * tip, is deeper beside it. Uses up to 4096 points, evenly spaced.
 */
PALPATE_EXPORT TiltNeed tiltNeed(const ResponseArrays& arrays, double tolerance);

/// The need in a sentence without its full stop; "" for a response without tilts.
PALPATE_EXPORT std::string tiltReason(
  const TiltNeed& need, const TiltViews& tilts, double tolerance);
} // namespace palpate

#endif
