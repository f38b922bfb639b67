// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseSampling_h
#define palpate_ResponseSampling_h

#include <cmath>
#include <cstddef>
#include <vector>

namespace palpate
{
struct ResponseValue
{
  double force = 0.0;     ///< N
  double stiffness = 0.0; ///< dF/dδ, N/mm
  bool beyondRange = false;
};

/**
 * How a force-deflection curve is stored in n samples, and evaluated from them.
 *
 * Samples i = 1..n lie at s_i = i/n, δ_i = δ_max s_i²; F(0) = 0 is not stored. Between them
 *   F(δ) = δ^m r(s), s = √(δ/δ_max),
 * with r the cubic Hermite interpolant whose values and slopes follow from the stored F_i and
 * K_i = dF/dδ. Below δ_1 the power start F = F_1 (δ/δ_1)^q, q = K_1 δ_1/F_1 (0 if F_1 = 0). Beyond
 * δ_max the last tangent. The curve is continuously differentiable, and exact for F ∝ δ^m.
 *
 * δ <= 0 gives 0, NaN gives NaN. evaluate() neither allocates nor throws.
 */
class ResponseSampling
{
public:
  /// More samples than this are taken for a damaged file or a slip.
  static constexpr int LargestCount = 256;

  /// 2 to LargestCount samples; m > 0 finite.
  ResponseSampling(int samples, double exponent);

  int samples() const noexcept { return this->Samples; }
  double exponent() const noexcept { return this->Exponent; }
  /// δ_i of sample i = 0..n-1 (the i+1-th of the text above).
  double depth(int i, double range) const noexcept
  {
    const double s = static_cast<double>(i + 1) / this->Samples;
    return range * (s * s);
  }

  /// `curve.force(i)` and `curve.stiffness(i)` give sample i = 0..n-1.
  template <class Curve>
  ResponseValue evaluate(const Curve& curve, double range, double deflection) const noexcept
  {
    if (!(deflection > 0.0))
    {
      return { deflection <= 0.0 ? 0.0 : deflection, deflection <= 0.0 ? 0.0 : deflection, false };
    }
    const int n = this->Samples;
    if (deflection >= range)
    {
      const double stiffness = curve.stiffness(n - 1);
      return { curve.force(n - 1) + stiffness * (deflection - range), stiffness,
        deflection > range };
    }
    const double s = std::sqrt(deflection / range);
    const double position = s * n;
    const int i = position < n - 1 ? static_cast<int>(position) : n - 1;
    return i == 0 ? this->powerStart(curve, range, deflection)
                  : this->hermite(curve, range, s, position, i);
  }

private:
  template <class Curve>
  ResponseValue powerStart(const Curve& curve, double range, double deflection) const noexcept
  {
    const double first = this->depth(0, range);
    const double force = curve.force(0);
    if (force == 0.0)
    {
      return {};
    }
    const double q = curve.stiffness(0) * first / force;
    const double value = force * std::pow(deflection / first, q);
    return { value, q * value / deflection, false };
  }

  /// Between samples i-1 and i, 1 <= i < n. With ρ(s) = F/s^(2m), the factor δ_max^m cancels.
  template <class Curve>
  ResponseValue hermite(
    const Curve& curve, double range, double s, double position, int i) const noexcept
  {
    const double h = 1.0 / this->Samples;
    const double t = position - i;
    const Node a = this->node(curve, range, i - 1);
    const Node b = this->node(curve, range, i);
    const double t2 = t * t;
    const double t3 = t2 * t;
    const double rho = (2.0 * t3 - 3.0 * t2 + 1.0) * a.value + (t3 - 2.0 * t2 + t) * h * a.slope +
      (3.0 * t2 - 2.0 * t3) * b.value + (t3 - t2) * h * b.slope;
    const double slope = (6.0 * t2 - 6.0 * t) / h * (a.value - b.value) +
      (3.0 * t2 - 4.0 * t + 1.0) * a.slope + (3.0 * t2 - 2.0 * t) * b.slope;
    const double power = std::pow(s, 2.0 * this->Exponent);
    return { power * rho, power * (2.0 * this->Exponent * rho / s + slope) / (2.0 * range * s),
      false };
  }

  struct Node
  {
    double value;
    double slope;
  };
  template <class Curve>
  Node node(const Curve& curve, double range, int i) const noexcept
  {
    const double s = static_cast<double>(i + 1) / this->Samples;
    const double weight = this->Weights[static_cast<std::size_t>(i)];
    const double force = curve.force(i);
    return { weight * force,
      2.0 * weight * (range * s * curve.stiffness(i) - this->Exponent * force / s) };
  }

  int Samples;
  double Exponent;
  std::vector<double> Weights; ///< s_i^(-2m)
};
} // namespace palpate

#endif
