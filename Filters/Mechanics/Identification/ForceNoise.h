// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceNoise_h
#define palpate_ForceNoise_h

#include "Mechanics/PalpateExport.h"

#include <limits>
#include <vector>

namespace palpate
{
/// Standard deviation of the readings of force, N, and how well it is known: as if from so many
/// independent readings.
struct ForceNoise
{
  double deviation = 0.0;
  double degreesOfFreedom = std::numeric_limits<double>::infinity();
};

/**
 * What is left of each run of four neighbouring readings after their parabola, taken together by
 * its median: the kink at first contact and single outliers do not count. Depths ascend; readings
 * of several loads at one depth compare with each other, so that what does not repeat is noise.
 *
 * A median of absolute deviations knows a deviation as well as 0.37 n free readings (Rousseeuw and
 * Croux 1993); overlapping runs share readings, so a quarter of n is counted. Fewer than four
 * readings: NaN.
 */
PALPATE_EXPORT ForceNoise estimateForceNoise(
  const std::vector<double>& deflection, const std::vector<double>& force);
} // namespace palpate

#endif
