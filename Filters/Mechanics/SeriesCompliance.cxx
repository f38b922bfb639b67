// SPDX-License-Identifier: BSD-3-Clause
#include "SeriesCompliance.h"

#include <cmath>
#include <limits>

namespace palpate
{
SeriesPoint seriesResponse(
  const AxisymmetricTool& tool, double reducedModulus, double compliance, double deflection)
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
  // From x = δ the residual x + C F(x) - δ has the sign of C and its tangents never overshoot.
  double x = deflection;
  for (int iteration = 0; iteration < 100; ++iteration)
  {
    point.force = tool.force(x, reducedModulus);
    const double local = tool.stiffness(x, reducedModulus);
    const double slope = 1.0 + compliance * local;
    if (!(slope > 0.0))
    {
      return { nan, nan, nan, false };
    }
    point.stiffness = local / slope;
    point.localDeflection = x;
    const double step = (x + compliance * point.force - deflection) / slope;
    x -= step;
    if (!(std::abs(step) > 1e-15 * x))
    {
      return point;
    }
  }
  return { nan, nan, nan, false };
}
} // namespace palpate
