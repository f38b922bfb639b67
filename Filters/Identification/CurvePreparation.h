// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CurvePreparation_h
#define palpate_CurvePreparation_h

#include "Identification/MeasuredCurve.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace palpate
{
/// The readings of one loading, in the order in which they were taken.
struct LoadingBranch
{
  std::vector<double> deflection;
  std::vector<double> force;
  double speed = std::numeric_limits<double>::quiet_NaN();      ///< mm/s; NaN without times
  double hysteresis = std::numeric_limits<double>::quiet_NaN(); ///< NaN without an unloading
};

/// The branches of a curve, and measures of its deviation from the curve of an elastic body.
struct PreparedCurve
{
  std::vector<LoadingBranch> loads;
  /// Largest fraction of the energy of a loading that its unloading does not return; NaN without an
  /// unloading.
  double hysteresis = std::numeric_limits<double>::quiet_NaN();
  /// Relative difference in energy, over their common depths, between the fastest and the slowest
  /// loading; NaN unless the ratio of their speeds is at least 1.5.
  double rateEffect = std::numeric_limits<double>::quiet_NaN();
  /// Largest fraction of its force that a hold at the end of a loading loses; NaN without a hold.
  double holdLoss = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::size_t>
    turns; ///< readings at which a branch or a hold begins or ends, ascending
};

/// Limits for a curve to count as elastic.
struct ElasticityLimits
{
  double hysteresis = 0.2;
  double rateEffect = 0.1; ///< also the largest fraction of the force that a hold loses
};

/**
 * Separates the loading branches of a curve from unloading and hold, and measures hysteresis, rate
 * effect and loss in holds.
 *
 * The branches follow the recorded phases, or without them the turning points of the deflection: a
 * branch ends where the deflection turns back by more than a tenth of its whole range. Readings
 * during a rest at a turning point belong to no branch, since the force may relax there.
 *
 * Returns the reason why the curve is refused, or "". `prepared` is filled in either case.
 */
PALPATE_EXPORT std::string prepareCurve(
  const MeasuredCurve& curve, const ElasticityLimits& limits, PreparedCurve& prepared);

/// Whether a prepared curve exceeds the limits in a way that shows relaxation: it loses energy in
/// loops, is stiffer when pressed faster, or its force falls during a hold.
PALPATE_EXPORT bool relaxes(const PreparedCurve& prepared, const ElasticityLimits& limits);
} // namespace palpate

#endif
