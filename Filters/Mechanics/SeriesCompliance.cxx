// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/SeriesCompliance.h"

#include "Mechanics/Numerics/Constants.h"

#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// Limits relative to the deflection. `Overshoot` is the smallest step in the wrong direction that
// exceeds the rounding error. `Rounding` is the size of the last step of an iteration that has
// overshot.
constexpr double Overshoot = 1e-12;
constexpr double Rounding = 4e-15;
} // namespace

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
  // Newton's method on x + C F(x) = δ, written so that no terms cancel (K x >= F). If F is convex,
  // the iteration that starts at x = δ never overshoots. A step that makes no progress has then
  // reached the rounding error and is the last step. If the iteration overshoots, as for a flat end
  // at finite strain, the root is kept between two bounds.
  double x = deflection;
  double low = 0.0;
  double high = Infinity;
  bool overshoots = false;
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
    double next = (deflection + compliance * (at.stiffness * x - at.force)) / slope;
    (next < x ? high : low) = x;
    const double progress = compliance < 0.0 ? next - x : x - next;
    overshoots = overshoots || progress < -Overshoot * x;
    if (overshoots && !(next > low && next < high))
    {
      next = high < Infinity ? 0.5 * (low + high) : 2.0 * x;
    }
    last = overshoots ? std::abs(next - x) <= Rounding * x : !(progress > 1e-15 * x);
    x = next;
  }
  return { nan, nan, nan, false };
}
} // namespace palpate
