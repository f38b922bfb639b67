// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseSampling_h
#define palpate_ResponseSampling_h

#include "Mechanics/PalpateExport.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace palpate
{
/// A curve at one depth.
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
class PALPATE_EXPORT ResponseSampling
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

  /// s^(2m), by products where 2m is a small whole number.
  double rootPower(double s) const noexcept
  {
    if (this->WholePower == 0)
    {
      return std::pow(s, 2.0 * this->Exponent);
    }
    double power = s;
    for (int i = 1; i < this->WholePower; ++i)
    {
      power *= s;
    }
    return power;
  }

  /// Where a deflection lies among the samples: for curves of the same range at the same place, so
  /// that it is found once for the three vertices of a triangle.
  struct Place
  {
    int lower = -1; ///< between samples `lower` and `lower + 1`; -1: below the first
    bool beyondRange = false;
    double deflection = 0.0;
    double range = 0.0;
    double inverseRoot = 0.0; ///< 1/s
    double root = 0.0;        ///< s
    double share = 0.0;       ///< of the way from sample `lower` to the next
  };

  /// For δ > 0; range > 0.
  Place place(double range, double deflection) const noexcept
  {
    Place at;
    at.deflection = deflection;
    at.range = range;
    at.beyondRange = deflection > range;
    const int n = this->Samples;
    if (deflection >= range)
    {
      at.lower = n - 2;
      at.share = 1.0;
      return at;
    }
    // 1/s first: with it, one root and two divisions that do not wait for each other give all.
    at.inverseRoot = std::sqrt(range / deflection);
    at.root = deflection / range * at.inverseRoot;
    const double position = at.root * n;
    const int upper = position < n - 1 ? static_cast<int>(position) : n - 1;
    at.lower = upper - 1;
    at.share = position - upper;
    return at;
  }

  /// F, K of two neighbouring samples of a curve, or of a sum of curves.
  struct Samples2
  {
    double lowerForce, lowerStiffness, upperForce, upperStiffness;
  };

  /// At a place that is not below the first sample.
  ResponseValue between(const Samples2& samples, const Place& at) const noexcept
  {
    if (at.deflection >= at.range)
    {
      return { samples.upperForce + samples.upperStiffness * (at.deflection - at.range),
        samples.upperStiffness, at.beyondRange };
    }
    return this->hermite(samples, at);
  }

  /// `curve.force(i)` and `curve.stiffness(i)` give sample i = 0..n-1.
  template <class Curve>
  ResponseValue evaluate(const Curve& curve, const Place& at) const noexcept
  {
    if (at.lower < 0)
    {
      return this->powerStart(curve, at.range, at.deflection);
    }
    return this->between({ curve.force(at.lower), curve.stiffness(at.lower),
                           curve.force(at.lower + 1), curve.stiffness(at.lower + 1) },
      at);
  }

  template <class Curve>
  ResponseValue evaluate(const Curve& curve, double range, double deflection) const noexcept
  {
    if (!(deflection > 0.0))
    {
      const double zeroOrNaN = deflection <= 0.0 ? 0.0 : deflection;
      return { zeroOrNaN, zeroOrNaN, false };
    }
    return this->evaluate(curve, this->place(range, deflection));
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

  /// With ρ(s) = F/s^(2m), the factor δ_max^m cancels; sample i holds ρ_i = w_i F_i and
  /// dρ/ds = w_i (2 δ_max s_i K_i - 2m F_i/s_i), w_i = s_i^(-2m). Between two of them, t of the
  /// way, ρ = ρ_0 + t (a + t (b + t c)).
  ResponseValue hermite(const Samples2& samples, const Place& at) const noexcept
  {
    const Node& lower = this->Nodes[static_cast<std::size_t>(at.lower)];
    const Node& upper = this->Nodes[static_cast<std::size_t>(at.lower) + 1];
    const double twice = 2.0 * at.range;
    const double rise =
      upper.weight * samples.upperForce - lower.weight * samples.lowerForce; // ρ_1 - ρ_0
    const double a = this->Spacing * lower.weight *
      (twice * lower.root * samples.lowerStiffness + lower.ofForce * samples.lowerForce);
    const double end = this->Spacing * upper.weight *
      (twice * upper.root * samples.upperStiffness + upper.ofForce * samples.upperForce);
    const double b = 3.0 * rise - 2.0 * a - end;
    const double c = a + end - 2.0 * rise;
    const double t = at.share;
    const double rho = lower.weight * samples.lowerForce + t * (a + t * (b + t * c));
    const double slope = (a + t * (2.0 * b + t * (3.0 * c))) * this->Samples; // dρ/ds
    const double power = this->rootPower(at.root);
    const double force = power * rho;
    // ds/dδ = 1/(2 δ_max s)
    const double stiffness = 0.5 / at.range * at.inverseRoot *
      (2.0 * this->Exponent * at.inverseRoot * force + power * slope);
    return { force, stiffness, at.beyondRange };
  }

  int Samples;
  double Exponent;
  int WholePower; ///< 2m if that is whole and small, else 0
  double Spacing; ///< 1/n
  struct Node
  {
    double root;    ///< s_i
    double weight;  ///< s_i^(-2m)
    double ofForce; ///< -2m/s_i
  };
  std::vector<Node> Nodes;
};
} // namespace palpate

#endif
