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
 * Whether the stiffness of a stored curve only rises with the deflection, as ResponseSampling
 * evaluates it, all the way: then so does that of every blend of such curves, and a stiffness that
 * is reached is passed once (CappedResponse).
 *
 * Between two samples dK/dδ has the sign of
 *   p(p-2) ρ + (2p-1) s ρ' + s² ρ'',  p = 2m,
 * a cubic of the way from one to the other, whose coefficients in Bernstein's form are linear in
 * the forces and stiffnesses of the two: where none of these is negative, the cubic is not. (That
 * is sufficient; a curve that rises and does not show it so counts as one that does not.) Below the
 * first sample the power must be at least 1; beyond the last the stiffness is constant.
 *
 * Samples are floats: what could be their rounding does not count as a fall.
 *
 * Made once for a sampling, asked once for each point when a body is built: some 100 ns with 8
 * samples.
 */
class RisingStiffness
{
public:
  explicit RisingStiffness(const ResponseSampling& sampling);

  /// `curve.force(i)` and `curve.stiffness(i)` give sample i = 0..n-1; range in mm, > 0.
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
  /// Of a float, and once more for the range's.
  static constexpr double Rounding = 1.2e-7;
  /// Bernstein's four coefficients, of force, range times stiffness, and those of the next sample.
  using Cell = std::array<std::array<double, 4>, 4>;

  double FirstDepth; ///< of the first sample, of the range
  std::vector<Cell> Cells;
};
} // namespace palpate

#endif
