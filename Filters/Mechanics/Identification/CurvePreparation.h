// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CurvePreparation_h
#define palpate_CurvePreparation_h

#include "Mechanics/Identification/MeasuredCurve.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace palpate
{
/// The readings of one loading, in the order they were taken.
struct LoadingBranch
{
  std::vector<double> deflection;
  std::vector<double> force;
  double speed = std::numeric_limits<double>::quiet_NaN();      ///< mm/s; NaN without times
  double hysteresis = std::numeric_limits<double>::quiet_NaN(); ///< NaN without an unloading
};

/// A curve taken apart, and how far it is from that of an elastic body.
struct PreparedCurve
{
  std::vector<LoadingBranch> loads;
  /// Share of the energy of a loading that its unloading does not give back: the largest one; NaN
  /// where no unloading was recorded.
  double hysteresis = std::numeric_limits<double>::quiet_NaN();
  /// Relative difference in energy, over the depths they share, between the fastest and the slowest
  /// loading; NaN where no two speeds differ by half.
  double rateEffect = std::numeric_limits<double>::quiet_NaN();
  /// Share of its force that a hold at the end of a loading loses: the largest one; NaN where
  /// nothing was held.
  double holdLoss = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::size_t>
    turns; ///< readings at which a branch or a hold begins or ends, ascending
};

/// How far from elastic a curve may be, to be taken for elastic.
struct ElasticityLimits
{
  double hysteresis = 0.2;
  double rateEffect = 0.1; ///< and of the force that a hold loses
};

/**
 * Separates the loading branches of a curve from unloading and hold, and judges it.
 *
 * By its phases where they were recorded; otherwise by the turning points of the deflection: a
 * branch ends where the deflection turns back by more than a tenth of its whole range. Readings
 * while the deflection rests at a turning point belong to no branch: the force may relax there.
 *
 * Returns why the curve is refused, or "". What was found is in `prepared` in either case.
 */
PALPATE_EXPORT std::string prepareCurve(
  const MeasuredCurve& curve, const ElasticityLimits& limits, PreparedCurve& prepared);

/// Whether a prepared curve is beyond the limits as that of a body is that relaxes: it loses energy
/// in loops, is stiffer when pressed faster, or its force falls while it is held.
PALPATE_EXPORT bool relaxes(const PreparedCurve& prepared, const ElasticityLimits& limits);
} // namespace palpate

#endif
