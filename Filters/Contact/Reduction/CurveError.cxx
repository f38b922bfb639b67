// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Reduction/CurveError.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
CurveError curveError(
  const SampledCurve& right, const SampledCurve& reduced, double range, std::size_t point)
{
  const int steps = 4 * right.sampling.samples();
  CurveError error;
  error.point = point;
  double steepest = 0.0;
  for (int step = 1; step <= steps; ++step)
  {
    const double s = static_cast<double>(step) / steps;
    const double depth = range * (s * s);
    const ResponseValue expected = right.evaluate(range, depth);
    const ResponseValue found = reduced.evaluate(range, depth);
    const double off =
      std::abs(found.force - expected.force) / std::max(expected.force, right.force(0));
    if (!std::isfinite(off) || !std::isfinite(found.stiffness))
    {
      error.force = std::numeric_limits<double>::infinity();
      return error;
    }
    error.force = std::max(error.force, off);
    error.slope = std::max(error.slope, std::abs(found.stiffness - expected.stiffness));
    steepest = std::max(steepest, std::abs(expected.stiffness));
  }
  error.slope = steepest > 0.0 ? error.slope / steepest : 0.0;
  return error;
}
} // namespace palpate
