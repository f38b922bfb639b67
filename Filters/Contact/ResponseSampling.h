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

  /**
   * How force and stiffness at one deflection follow from the samples: for curves of the same
   * range the same, so it is made once for the three vertices of a triangle. Between samples
   * `lower` and `lower + 1`: force = Σ force_j v_j and dF/dδ = Σ stiffness_j v_j with
   * v = (F_lower, K_lower, F_lower+1, K_lower+1). Below the first sample (lower = -1) the curve's
   * own exponent counts and there is no such sum.
   */
  struct Stencil
  {
    int lower = -1;
    bool beyondRange = false;
    double deflection = 0.0;
    double range = 0.0;
    double force[4] = { 0.0, 0.0, 0.0, 0.0 };
    double stiffness[4] = { 0.0, 0.0, 0.0, 0.0 };
  };

  /// For δ > 0; range > 0. Filled in place: a copy would wait for what was just stored.
  void place(Stencil& at, double range, double deflection) const noexcept
  {
    at.deflection = deflection;
    at.range = range;
    at.beyondRange = deflection > range;
    at.lower = -1;
    const int n = this->Samples;
    if (deflection >= range)
    {
      at.lower = n - 2;
      for (int j = 0; j < 4; ++j)
      {
        at.force[j] = j == 2 ? 1.0 : j == 3 ? deflection - range : 0.0;
        at.stiffness[j] = j == 3 ? 1.0 : 0.0;
      }
      return;
    }
    // 1/s first: with it, one root and two divisions that do not wait for each other give all.
    const double inverse = std::sqrt(range / deflection);
    const double s = deflection / range * inverse;
    const double position = s * n;
    const int upper = position < n - 1 ? static_cast<int>(position) : n - 1;
    if (upper > 0)
    {
      this->hermite(at, s, inverse, position, upper);
    }
  }

  /// `curve.force(i)` and `curve.stiffness(i)` give sample i = 0..n-1.
  template <class Curve>
  ResponseValue evaluate(const Curve& curve, const Stencil& at) const noexcept
  {
    if (at.lower < 0)
    {
      return this->powerStart(curve, at.range, at.deflection);
    }
    const double values[4] = { curve.force(at.lower), curve.stiffness(at.lower),
      curve.force(at.lower + 1), curve.stiffness(at.lower + 1) };
    ResponseValue value;
    value.beyondRange = at.beyondRange;
    for (int j = 0; j < 4; ++j)
    {
      value.force += at.force[j] * values[j];
      value.stiffness += at.stiffness[j] * values[j];
    }
    return value;
  }

  template <class Curve>
  ResponseValue evaluate(const Curve& curve, double range, double deflection) const noexcept
  {
    if (!(deflection > 0.0))
    {
      const double zeroOrNaN = deflection <= 0.0 ? 0.0 : deflection;
      return { zeroOrNaN, zeroOrNaN, false };
    }
    Stencil at;
    this->place(at, range, deflection);
    return this->evaluate(curve, at);
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

  /// Between samples upper-1 and upper, 1 <= upper < n. With ρ(s) = F/s^(2m), the factor δ_max^m
  /// cancels; sample i holds ρ_i = w_i F_i and dρ/ds = 2 w_i (δ_max s_i K_i - m F_i/s_i), w_i =
  /// s_i^(-2m).
  void hermite(Stencil& at, double s, double inverse, double position, int upper) const noexcept
  {
    const double h = this->Spacing;
    const double t = position - upper;
    const double t2 = t * t;
    const double t3 = t2 * t;
    const double rho[4] = { 2.0 * t3 - 3.0 * t2 + 1.0, h * (t3 - 2.0 * t2 + t), 3.0 * t2 - 2.0 * t3,
      h * (t3 - t2) };
    const double steep = (6.0 * t2 - 6.0 * t) * this->Samples;
    const double slope[4] = { steep, 3.0 * t2 - 4.0 * t + 1.0, -steep, 3.0 * t2 - 2.0 * t };
    const double power = this->rootPower(s);
    const double rise = 0.5 / at.range * inverse; // ds/dδ
    const double growth = 2.0 * this->Exponent * inverse;
    at.lower = upper - 1;
    for (int j = 0; j < 4; j += 2)
    {
      const Node& node = this->Nodes[static_cast<std::size_t>(j == 0 ? at.lower : at.lower + 1)];
      const double weight = power * node.weight;
      const double ofStiffness = weight * 2.0 * at.range * node.root;
      at.force[j] = weight * (rho[j] + node.ofForce * rho[j + 1]);
      at.force[j + 1] = ofStiffness * rho[j + 1];
      at.stiffness[j] =
        rise * (growth * at.force[j] + weight * (slope[j] + node.ofForce * slope[j + 1]));
      at.stiffness[j + 1] = rise * (growth * at.force[j + 1] + ofStiffness * slope[j + 1]);
    }
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
