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
/// The readings of one loading, in the order of measurement.
struct LoadingBranch
{
  std::vector<double> deflection;
  std::vector<double> force;
  double speed = std::numeric_limits<double>::quiet_NaN();      ///< mm/s; NaN if there are no times
  double hysteresis = std::numeric_limits<double>::quiet_NaN(); ///< NaN if there is no unloading
};

/// The loading branches of a curve, and measures of its deviation from the curve of an elastic
/// body.
struct PreparedCurve
{
  std::vector<LoadingBranch> loads;
  /// Largest fraction of a loading's energy that is not recovered on unloading; NaN if there is no
  /// unloading.
  double hysteresis = std::numeric_limits<double>::quiet_NaN();
  /// Relative difference in energy between the fastest and the slowest loading, over their common
  /// depths; NaN if the ratio of their speeds is less than 1.5.
  double rateEffect = std::numeric_limits<double>::quiet_NaN();
  /// Largest relative decrease of the force in a hold at the end of a loading; NaN if there is no
  /// hold.
  double holdLoss = std::numeric_limits<double>::quiet_NaN();
  /// Readings at which a branch or a hold begins or ends, ascending.
  std::vector<std::size_t> turns;
};

/// Limits within which a curve counts as elastic.
struct ElasticityLimits
{
  double hysteresis = 0.2;
  double rateEffect = 0.1; ///< also the limit for holdLoss
};

/**
 * Separates the loading branches of a curve from unloadings and holds. Measures the hysteresis, the
 * rate effect and the decrease of the force in holds.
 *
 * If phases are recorded, they define the branches. Otherwise a branch ends at a turning point,
 * where the deflection reverses by more than a tenth of its total range. Readings at rest at a
 * turning point do not belong to a branch, because the force may relax.
 *
 * Returns the reason why the curve is refused, or "". `prepared` is set in either case.
 */
PALPATE_EXPORT std::string prepareCurve(
  const MeasuredCurve& curve, const ElasticityLimits& limits, PreparedCurve& prepared);

/// Returns whether a prepared curve exceeds the limits in a way that shows relaxation: energy is
/// lost in loops, the curve is stiffer at a higher speed, or the force decreases during a hold.
PALPATE_EXPORT bool relaxes(const PreparedCurve& prepared, const ElasticityLimits& limits);
} // namespace palpate

#endif
