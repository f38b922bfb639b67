// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/SeriesCompliance.h"

#include <cmath>
#include <limits>

namespace palpate
{
SeriesPoint seriesResponse(
  const IndentationLaw& local, double reducedModulus, double compliance, double deflection)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  SeriesPoint point;
  if (!(deflection > 0.0) || !std::isfinite(compliance))
  {
    if (std::isnan(deflection) || !std::isfinite(compliance))
    {
      point = { nan, nan, nan, false };
    }
    return point;
  }
  // Newton's method on x + C F(x) = δ, written so that nothing cancels (K x >= F). From x = δ on,
  // the tangents never overshoot. A step that makes no progress has reached the rounding error and
  // is the last.
  double x = deflection;
  bool last = false;
  for (int iteration = 0; iteration < 100; ++iteration)
  {
    const IndentationPoint at = local.evaluate(x, reducedModulus);
    const double slope = 1.0 + compliance * at.stiffness;
    if (!(slope > 0.0))
    {
      return { nan, nan, nan, false };
    }
    point.force = at.force;
    point.stiffness = at.stiffness / slope;
    point.localDeflection = x;
    if (last)
    {
      return point;
    }
    const double next = (deflection + compliance * (at.stiffness * x - at.force)) / slope;
    last = !((compliance < 0.0 ? next - x : x - next) > 1e-15 * x);
    x = next;
  }
  return { nan, nan, nan, false };
}
} // namespace palpate
