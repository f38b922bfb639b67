// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Estimate_h
#define palpate_Estimate_h

#include "Mechanics/PalpateExport.h"

#include <limits>

namespace palpate
{
/// A number and its 95 % confidence interval.
struct Estimate
{
  double value = std::numeric_limits<double>::quiet_NaN();
  double lower = std::numeric_limits<double>::quiet_NaN();
  double upper = std::numeric_limits<double>::quiet_NaN();
};

/// Return an estimate with its confidence interval. `error` is half the width of the interval: of
/// ln value for logarithmicEstimate(), and of value for linearEstimate().
PALPATE_EXPORT Estimate logarithmicEstimate(double value, double error);
PALPATE_EXPORT Estimate linearEstimate(double value, double error);

/// Returns the 97.5 % quantile of Student's t (Abramowitz and Stegun 26.7.5; error 1e-3 for ν >=
/// 5).
PALPATE_EXPORT double studentQuantile(double degreesOfFreedom);
} // namespace palpate

#endif
