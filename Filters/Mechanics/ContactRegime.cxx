// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/ContactRegime.h"

#include <cmath>
#include <limits>

namespace palpate
{
double regimeIndex(
  const IndentationLaw& halfSpace, double reducedModulus, double force, double deflection)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!(force > 0.0 && deflection > 0.0 && std::isfinite(force) && std::isfinite(deflection)))
  {
    return nan;
  }
  // Newton's method on F(x) = force. F is convex, so that x decreases in every step after the
  // first. A step that does not decrease x has reached the rounding error.
  double x = deflection;
  for (int iteration = 0; iteration < 100; ++iteration)
  {
    const IndentationPoint at = halfSpace.evaluate(x, reducedModulus);
    const double next = x - (at.force - force) / at.stiffness;
    if (iteration > 0 && !(x - next > 1e-15 * x))
    {
      return 1.0 - next / deflection;
    }
    x = next;
  }
  return nan;
}

RegimeVerdict regimeVerdict(double sensitivity)
{
  // With F ∝ size^S, the limits are 2^S - 1 > 10 % and 4^S - 1 < 5 %.
  static const double felt = std::log(1.1) / std::log(2.0);
  static const double unfelt = std::log(1.05) / std::log(4.0);
  const double s = std::abs(sensitivity);
  return s > felt ? RegimeVerdict::ShapeMatters
    : s < unfelt  ? RegimeVerdict::PointForceSuffices
                  : RegimeVerdict::Mixed;
}
} // namespace palpate
