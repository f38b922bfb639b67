// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltNeed_h
#define palpate_TiltNeed_h

#include "Contact/ResponseField.h"
#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
/// Whether tilt data are needed to keep the error of the force within a tolerance.
struct TiltNeed
{
  double change = 0.0; ///< largest relative change of the force by any tilt
  double angle = 0.0;  ///< tilt at which this change occurs, rad
  /// Fraction of the points at which no tilt changes the force by more than the tolerance, 0 to 1.
  double without = 0.0;
  double torque = 0.0; ///< largest torque, N mm
  bool isFelt = false; ///< whether the change exceeds the tolerance at one or more points
};

/**
 * Computes the change of the force by a tilt at equal depth of the tip, for eight tilts up to the
 * largest. The depth is half of each point's range. If a tool with a flat or round end is tilted
 * about its tip, its deepest point is deeper than the tip; the change includes this effect. Uses up
 * to 4096 evenly spaced points.
 */
PALPATE_EXPORT TiltNeed tiltNeed(const ResponseArrays& arrays, double tolerance);

/// Returns the result as a sentence without its full stop; "" for a response without tilt data.
PALPATE_EXPORT std::string tiltReason(
  const TiltNeed& need, const TiltViews& tilts, double tolerance);
} // namespace palpate

#endif
