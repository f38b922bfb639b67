// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PressHistory_h
#define palpate_PressHistory_h

#include "Mechanics/Identification/BodyFit.h"
#include "Mechanics/Identification/CurvePreparation.h"
#include "Mechanics/Identification/ForceNoise.h"
#include "Mechanics/Identification/MeasuredCurve.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/**
 * What one tool did to a body, and felt, in the order of time: presses, holds, releases. Between
 * its points the depth moves evenly. Before the first one the body had been at rest.
 */
struct PressHistory
{
  const AxisymmetricTool* tool = nullptr;
  std::vector<double> time;       ///< s, never decreasing
  std::vector<double> deflection; ///< mm, counted from anywhere
  std::vector<double> force;      ///< N
  /// Each point is the mean of so many readings; 0: a place on the way that is not compared.
  std::vector<double> readings;
  IndentationCurve loading; ///< of it the loads alone, of ascending depth; where a fit starts
  ForceNoise noise;         ///< of a reading

  std::size_t size() const noexcept { return this->time.size(); }
};

/// From a curve with times. Neighbours in time are averaged where there are more than 600, as
/// closely as forces may change: over 0.5 % of the depth and 3 % of the time since the last turn.
PALPATE_EXPORT PressHistory makeHistory(
  const AxisymmetricTool& tool, const MeasuredCurve& curve, const PreparedCurve& prepared);

/// What of relaxation a test can show, s.
struct TimeWindow
{
  double shortest = 0.0; ///< a fifteenth of the fastest press, or the time between two readings
  double longest = 0.0;  ///< the longest time in contact before the depth turns back
};

/// Of the points that are compared, those deeper than first contact at `offsets` (mm, of each).
PALPATE_EXPORT TimeWindow windowOf(
  const std::vector<PressHistory>& histories, const std::vector<double>& offsets);
} // namespace palpate

#endif
