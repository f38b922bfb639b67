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
 * Checks whether the stiffness of a stored curve, as ResponseSampling evaluates it, rises with the
 * deflection everywhere. Then the stiffness of every blend of such curves rises too, and equals a
 * given value only once (CappedResponse).
 *
 * Between two samples dK/dδ has the sign of
 *   p(p-2) ρ + (2p-1) s ρ' + s² ρ'',  p = 2m,
 * a cubic in the fraction of the interval between them. Its Bernstein coefficients are linear in
 * the forces and stiffnesses of the two samples. If none of these coefficients is negative, the
 * cubic is not negative. (This condition is only sufficient: a rising curve may fail it and then
 * counts as not rising.) Below the first sample the power must be at least 1; beyond the last the
 * stiffness is constant.
 *
 * Samples are floats: a decrease within their rounding is ignored.
 *
 * Constructed once per sampling and called once per point when a body is built: about 100 ns with 8
 * samples.
 */
class RisingStiffness
{
public:
  explicit RisingStiffness(const ResponseSampling& sampling);

  /// `curve.force(i)` and `curve.stiffness(i)` return the values of sample i = 0..n-1; range in mm,
  /// > 0.
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
  /// Rounding of a sample as a float, plus that of the range.
  static constexpr double Rounding = 1.2e-7;
  /// The four Bernstein coefficients, each as four weights: of the force, of range times stiffness,
  /// and of the same two values at the next sample.
  using Cell = std::array<std::array<double, 4>, 4>;

  double FirstDepth; ///< depth of the first sample divided by the range
  std::vector<Cell> Cells;
};
} // namespace palpate

#endif
