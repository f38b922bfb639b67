// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceNoise_h
#define palpate_ForceNoise_h

#include "Mechanics/PalpateExport.h"

#include <limits>
#include <vector>

namespace palpate
{
/// The standard deviation of the force readings, N, and its accuracy, expressed as an equivalent
/// number of independent readings.
struct ForceNoise
{
  double deviation = 0.0;
  double degreesOfFreedom = std::numeric_limits<double>::infinity();
};

/**
 * Estimates the noise as the median residual of parabolas through each run of four neighbouring
 * readings. With the median, the kink at first contact and single outliers have no effect. Depths
 * must be ascending. Readings of several loadings at one depth are compared with each other, so
 * that differences between loadings count as noise.
 *
 * A median of absolute deviations is as accurate as 0.37 n independent readings (Rousseeuw and
 * Croux 1993). Overlapping runs share readings; therefore n/4 is used. The result is NaN for fewer
 * than four readings.
 */
PALPATE_EXPORT ForceNoise estimateForceNoise(
  const std::vector<double>& deflection, const std::vector<double>& force);
} // namespace palpate

#endif
