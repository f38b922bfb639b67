// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_IncreasingRoot_h
#define palpate_IncreasingRoot_h

#include <cmath>

namespace palpate
{
/// A function value and the derivative at the same point.
struct ValueAndSlope
{
  double value;
  double slope;
};

/**
 * Returns the root of an increasing function between `low` and `high`, exact to rounding. Uses
 * Newton's method from `start`, and bisection if a step would leave the present bounds. f(t) must
 * return f and f' at t.
 */
template <class Function>
double increasingRoot(Function&& f, double low, double high, double start)
{
  double t = start > low && start < high ? start : 0.5 * (low + high);
  for (int iteration = 0; iteration < 200; ++iteration)
  {
    const ValueAndSlope at = f(t);
    (at.value > 0.0 ? high : low) = t;
    double next = t - at.value / at.slope;
    if (next >= low && next <= high)
    {
      if (!(std::abs(next - t) > 1e-8 * t))
      {
        return next; // the size of the next step would be about the square of this step
      }
    }
    else
    {
      next = 0.5 * (low + high);
      if (next <= low || next >= high)
      {
        return next;
      }
    }
    t = next;
  }
  return t;
}
} // namespace palpate

#endif
