// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RisingStiffness_h
#define palpate_RisingStiffness_h

#include "Contact/ResponseSampling.h"

#include <array>
#include <cmath>
#include <vector>

namespace palpate
{
/**
 * Checks whether the stiffness of a stored curve, as ResponseSampling evaluates it, increases with
 * the deflection everywhere. Then the stiffness of every weighted mean of such curves increases
 * too, and equals a given value only once (CappedResponse).
 *
 * Between two samples dK/dδ has the sign of
 *   p(p-2) ρ + (2p-1) s ρ' + s² ρ'',  p = 2m,
 * which is a cubic in the fraction of the interval. Its Bernstein coefficients are linear in the
 * forces and stiffnesses of the two samples. If none of these coefficients is negative, the cubic
 * is not negative. (This condition is only sufficient: a curve of increasing stiffness may fail it
 * and is then treated as if its stiffness did not increase.) Below the first sample the power q
 * must be at least 1. Beyond the last sample the stiffness is constant.
 *
 * The samples are floats, so that a decrease within their rounding error is ignored.
 *
 * Constructed once per sampling, and called once per point when a body is built. A call takes about
 * 100 ns with 8 samples.
 */
class RisingStiffness
{
public:
  explicit RisingStiffness(const ResponseSampling& sampling);

  /// `curve.force(i)` and `curve.stiffness(i)` return the values of sample i = 0..n-1. `range` is
  /// in mm, > 0.
  template <class Curve>
  bool isOf(const Curve& curve, double range) const noexcept
  {
    const double first = curve.force(0);
    const double power = curve.stiffness(0) * this->FirstDepth * range;
    bool rises = first >= 0.0 && power >= first * (1.0 - 2.0 * Rounding) && std::isfinite(power);
    int lower = 0;
    for (const Cell& cell : this->Cells)
    {
      const std::array<double, 4> samples{ curve.force(lower), range * curve.stiffness(lower),
        curve.force(lower + 1), range * curve.stiffness(lower + 1) };
      ++lower;
      for (const std::array<double, 4>& share : cell)
      {
        double sum = 0.0;
        double size = 0.0;
        for (std::size_t k = 0; k < samples.size(); ++k)
        {
          const double part = share[k] * samples[k];
          sum += part;
          size += std::abs(part);
        }
        rises = rises && sum >= -Rounding * size;
      }
    }
    return rises;
  }

private:
  /// Sum of the relative rounding errors of a sample and of the range as floats.
  static constexpr double Rounding = 1.2e-7;
  /// The four Bernstein coefficients, each as four weights: of the force and of range times
  /// stiffness at one sample, and of the same two values at the next sample.
  using Cell = std::array<std::array<double, 4>, 4>;

  double FirstDepth; ///< depth of the first sample divided by the range
  std::vector<Cell> Cells;
};
} // namespace palpate

#endif
