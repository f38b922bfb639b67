// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PressHistory_h
#define palpate_PressHistory_h

#include "Identification/BodyFit.h"
#include "Identification/CurvePreparation.h"
#include "Identification/ForceNoise.h"
#include "Identification/MeasuredCurve.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/**
 * Depth and force of one tool on a body in the order of time, with presses, holds and releases.
 * Between points the depth changes linearly with time. The body was at rest before the first point.
 */
struct PressHistory
{
  const AxisymmetricTool* tool = nullptr;
  std::vector<double> time;       ///< s, never decreasing
  std::vector<double> deflection; ///< mm, from any origin
  std::vector<double> force;      ///< N
  /// Number of readings averaged at each point; 0 for an inserted point without a reading.
  std::vector<double> readings;
  IndentationCurve loading; ///< only the loadings, arranged; used for the initial values of a fit
  ForceNoise noise;         ///< noise of a reading

  std::size_t size() const noexcept { return this->time.size(); }
  /// Returns the force at a point minus the estimated baseline, N.
  double netForce(std::size_t point) const
  {
    return this->force[point] - this->loading.start.baseline.at(this->deflection[point]);
  }
};

/// Creates a history from a curve with times. If the curve has more than 600 readings, consecutive
/// readings are averaged over about 0.5 % of the depth of contact and 3 % of the time since the
/// last turning point.
PALPATE_EXPORT PressHistory makeHistory(const AxisymmetricTool& tool, const MeasuredCurve& curve,
  const PreparedCurve& prepared, bool findContact);

/// The range of relaxation times that a test can resolve, s.
struct TimeWindow
{
  /// 1/15 of the duration of the fastest press, or the smallest time between readings, s.
  double shortest = 0.0;
  double longest = 0.0; ///< the longest time in contact before the depth reverses, s
};

/// Returns the range of relaxation times that follows from the points with readings. `offsets` has
/// the deflection at first contact of each history, mm.
PALPATE_EXPORT TimeWindow windowOf(
  const std::vector<PressHistory>& histories, const std::vector<double>& offsets);
} // namespace palpate

#endif
