// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseEnergy_h
#define palpate_ResponseEnergy_h

#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseSampling.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace palpate
{
/**
 * The work e(δ) = ∫₀^δ F done by a stored response, N mm, as ResponseSampling evaluates it: exact
 * but for rounding, no quadrature in the tick.
 *
 * Whole cells between samples are linear in their forces and stiffnesses, with weights that depend
 * on n and m alone; they are computed once, here. The last, partial cell is integrated by parts:
 * with ρ the cubic of the cell and p = 2m + 1,
 *   ∫ s^p ρ ds = s^(p+1) (ρ/(p+1) - s ρ'/((p+1)(p+2)) + s² ρ''/(…(p+3)) - s³ ρ'''/(…(p+4))).
 * Below δ_1 the power start gives F_1 δ_1/(q+1) (δ/δ_1)^(q+1), which needs q > -1; beyond δ_max the
 * last tangent is integrated.
 *
 * δ <= 0 gives 0, NaN gives NaN. energy() takes O(n) and neither allocates nor throws.
 */
class PALPATE_EXPORT ResponseEnergy
{
public:
  explicit ResponseEnergy(const ResponseSampling& sampling);

  /// `curve.force(i)` and `curve.stiffness(i)` give sample i = 0..n-1.
  template <class Curve>
  double energy(const Curve& curve, double range, double deflection) const noexcept
  {
    if (!(deflection > 0.0))
    {
      return deflection <= 0.0 ? 0.0 : deflection;
    }
    const int n = this->Samples;
    if (deflection >= range)
    {
      const double beyond = deflection - range;
      return this->toSample(curve, range, n - 1) +
        beyond * (curve.force(n - 1) + 0.5 * beyond * curve.stiffness(n - 1));
    }
    const double s = std::sqrt(deflection / range);
    const double position = s * n;
    const int i = position < n - 1 ? static_cast<int>(position) : n - 1;
    if (i == 0)
    {
      const double whole = toFirstSample(curve, range);
      const double q = this->startPower(curve, range);
      return whole == 0.0 ? 0.0 : whole * std::pow(deflection / (range / (n * n)), q + 1.0);
    }
    return this->toSample(curve, range, i - 1) + this->partOfCell(curve, range, s, position - i, i);
  }

private:
  /// Of one sample to the energy of the cell on one side of it: e = δ_max (force F + stiffness
  /// δ_max K).
  struct Share
  {
    double force = 0.0;
    double stiffness = 0.0;
  };

  template <class Curve>
  double startPower(const Curve& curve, double range) const noexcept
  {
    const double first = range / (this->Samples * this->Samples);
    return curve.force(0) == 0.0 ? 0.0 : curve.stiffness(0) * first / curve.force(0);
  }

  template <class Curve>
  double toFirstSample(const Curve& curve, double range) const noexcept
  {
    const double first = range / (this->Samples * this->Samples);
    return curve.force(0) * first / (this->startPower(curve, range) + 1.0);
  }

  template <class Curve>
  double toSample(const Curve& curve, double range, int last) const noexcept
  {
    double sum = 0.0;
    for (int i = 0; i <= last; ++i)
    {
      const auto at = static_cast<std::size_t>(i);
      const Share& left = this->Left[at];
      const Share& right = this->Right[at];
      const double force = i < last ? left.force + right.force : left.force;
      const double stiffness = i < last ? left.stiffness + right.stiffness : left.stiffness;
      sum += force * curve.force(i) + stiffness * range * curve.stiffness(i);
    }
    return this->toFirstSample(curve, range) + range * sum;
  }

  /// From sample i-1 to s, a share t of the cell further on, 1 <= i < n.
  template <class Curve>
  double partOfCell(const Curve& curve, double range, double s, double t, int i) const noexcept
  {
    const double h = 1.0 / this->Samples;
    const Node a = this->node(curve, range, i - 1);
    const Node b = this->node(curve, range, i);
    const double rise = b.value - a.value;
    // ρ = a + t (c1 + t (c2 + t c3))
    const double c1 = h * a.slope;
    const double c2 = 3.0 * rise - h * (2.0 * a.slope + b.slope);
    const double c3 = h * (a.slope + b.slope) - 2.0 * rise;
    const double here = this->Sampling.rootPower(s) * s * s *
      this->byParts(s / h, a.value + t * (c1 + t * (c2 + t * c3)),
        c1 + t * (2.0 * c2 + 3.0 * t * c3), 2.0 * c2 + 6.0 * t * c3, 6.0 * c3);
    const double start = a.position * a.position / a.weight *
      this->byParts(a.position / h, a.value, c1, 2.0 * c2, 6.0 * c3);
    return 2.0 * range * (here - start);
  }

  /// The bracket of the text above; derivatives by t, x = s/h.
  double byParts(double x, double rho, double d1, double d2, double d3) const noexcept
  {
    const double p = 2.0 * this->Exponent + 1.0;
    return (rho - x / (p + 2.0) * (d1 - x / (p + 3.0) * (d2 - x / (p + 4.0) * d3))) / (p + 1.0);
  }

  /// As in ResponseSampling: ρ = s^(-2m) F and its slope.
  struct Node
  {
    double position;
    double weight;
    double value;
    double slope;
  };
  template <class Curve>
  Node node(const Curve& curve, double range, int i) const noexcept
  {
    const double s = static_cast<double>(i + 1) / this->Samples;
    const double weight = this->Weights[static_cast<std::size_t>(i)];
    const double force = curve.force(i);
    return { s, weight, weight * force,
      2.0 * weight * (range * s * curve.stiffness(i) - this->Exponent * force / s) };
  }

  ResponseSampling Sampling;
  int Samples;
  double Exponent;
  std::vector<double> Weights; ///< s_i^(-2m)
  std::vector<Share> Left;     ///< of each sample to the cell before it; none at the first
  std::vector<Share> Right;    ///< and after it; none at the last
};
} // namespace palpate

#endif
