// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseSampling_h
#define palpate_ResponseSampling_h

#include "Mechanics/PalpateExport.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace palpate
{
/// View of the stored samples of one point's curve, for ResponseSampling::evaluate().
struct FloatCurve
{
  const float* forces;      ///< N
  const float* stiffnesses; ///< N/mm
  double force(int i) const noexcept { return static_cast<double>(this->forces[i]); }
  double stiffness(int i) const noexcept { return static_cast<double>(this->stiffnesses[i]); }
};

/// Value of a curve at one depth.
struct ResponseValue
{
  double force = 0.0;     ///< N
  double stiffness = 0.0; ///< dF/dδ, N/mm
  bool beyondRange = false;
};

/**
 * Storage of a force-deflection curve in n samples, and its evaluation.
 *
 * Samples i = 1..n are at s_i = i/n, δ_i = δ_max s_i². F(0) = 0 is not stored. Between samples
 *   F(δ) = δ^m r(s), s = √(δ/δ_max),
 * where r is the cubic Hermite interpolant whose values and slopes follow from the stored F_i and
 * K_i = dF/dδ. Below δ_1 the curve is the power law F = F_1 (δ/δ_1)^q, q = K_1 δ_1/F_1 (0 if F_1 =
 * 0). Beyond δ_max it continues along its last tangent. The curve is continuously differentiable,
 * and exact for F ∝ δ^m.
 *
 * For δ <= 0 the result is 0, for NaN it is NaN. evaluate() neither allocates nor throws.
 */
class PALPATE_EXPORT ResponseSampling
{
public:
  /// Largest allowed number of samples. A larger number indicates a damaged file or a mistake.
  static constexpr int LargestCount = 256;

  /// `samples` is 2 to LargestCount; `exponent` is m > 0, finite.
  ResponseSampling(int samples, double exponent);

  int samples() const noexcept { return this->Samples; }
  double exponent() const noexcept { return this->Exponent; }
  /// Returns δ_i, mm. Here i = 0..n-1, whereas it is 1..n in the description of the class.
  double depth(int i, double range) const noexcept
  {
    const double s = static_cast<double>(i + 1) / this->Samples;
    return range * (s * s);
  }

  /// Returns s^(2m), computed by multiplications if 2m is a small whole number.
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

  /// Position of a deflection among the samples. It is the same for all curves with the same range,
  /// so that it is computed once for the three vertices of a triangle.
  struct Place
  {
    /// The position is between samples `lower` and `lower + 1`; -1 if it is below the first sample.
    int lower = -1;
    bool beyondRange = false;
    double deflection = 0.0;
    double range = 0.0;
    double inverseRoot = 0.0; ///< 1/s
    double root = 0.0;        ///< s
    double share = 0.0;       ///< position between sample `lower` (0) and the next sample (1)
  };

  /// Finds the position of a deflection. Both `range` and `deflection` must be > 0.
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
    // 1/s is computed first, so that one square root and two independent divisions suffice for all
    // values.
    at.inverseRoot = std::sqrt(range / deflection);
    at.root = deflection / range * at.inverseRoot;
    const double position = at.root * n;
    const int upper = position < n - 1 ? static_cast<int>(position) : n - 1;
    at.lower = upper - 1;
    at.share = position - upper;
    return at;
  }

  /// F and K of two neighbouring samples of a curve or of a sum of curves.
  struct Samples2
  {
    double lowerForce, lowerStiffness, upperForce, upperStiffness;
  };

  /// Evaluates the curve at a position that is not below the first sample.
  ResponseValue between(const Samples2& samples, const Place& at) const noexcept
  {
    if (at.deflection >= at.range)
    {
      return { samples.upperForce + samples.upperStiffness * (at.deflection - at.range),
        samples.upperStiffness, at.beyondRange };
    }
    return this->hermite(samples, at);
  }

  /// `curve.force(i)` and `curve.stiffness(i)` return the values of sample i = 0..n-1.
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

  /// With ρ(s) = F/s^(2m), the factor δ_max^m cancels. At sample i, ρ_i = w_i F_i and dρ/ds = w_i
  /// (2 δ_max s_i K_i - 2m F_i/s_i), with w_i = s_i^(-2m). Between two samples, at the fraction t,
  /// ρ = ρ_0 + t (a + t (b + t c)).
  ResponseValue hermite(const Samples2& samples, const Place& at) const noexcept
  {
    const Node* const nodes = this->Samples <= FewNodes ? this->Few.data() : this->Many.data();
    const Node& lower = nodes[at.lower];
    const Node& upper = nodes[at.lower + 1];
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
  int WholePower; ///< 2m if it is a small integer, else 0
  double Spacing; ///< 1/n
  struct Node
  {
    double root;    ///< s_i
    double weight;  ///< s_i^(-2m)
    double ofForce; ///< -2m/s_i
  };
  /// Up to this number of samples, nodes are stored within the object, which saves the tick an
  /// indirection.
  static constexpr int FewNodes = 16;
  std::array<Node, FewNodes> Few{};
  std::vector<Node> Many;
};

/**
 * The work e(δ) = ∫₀^δ F of a stored response, N mm, for a curve of ResponseSampling. It is exact
 * except for rounding. No numerical quadrature is needed in a tick.
 *
 * The integral over a whole interval between samples is linear in the forces and stiffnesses. Its
 * weights depend only on n and m and are computed once. The last, partial interval is integrated by
 * parts. With the cubic ρ of the interval and p = 2m + 1,
 *   ∫ s^p ρ ds = s^(p+1) (ρ/(p+1) - s ρ'/((p+1)(p+2)) + s² ρ''/(…(p+3)) - s³ ρ'''/(…(p+4))).
 * Below δ_1 the power law gives F_1 δ_1/(q+1) (δ/δ_1)^(q+1), which requires q > -1. Beyond δ_max
 * the last tangent is integrated.
 *
 * For δ <= 0 the result is 0, for NaN it is NaN. energy() takes O(n) time and neither allocates nor
 * throws.
 */
class PALPATE_EXPORT ResponseEnergy
{
public:
  explicit ResponseEnergy(const ResponseSampling& sampling);

  /// `curve.force(i)` and `curve.stiffness(i)` return the values of sample i = 0..n-1.
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
  /// Contribution of one sample to the energy of an adjacent interval: e = δ_max (force F +
  /// stiffness δ_max K).
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

  /// Returns the integral from sample i-1 to s, where s is at the fraction t of the interval, 1 <=
  /// i < n.
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

  /// Evaluates the expression in parentheses in the description of the class. The derivatives d1 to
  /// d3 of ρ are with respect to t; x = s/h.
  double byParts(double x, double rho, double d1, double d2, double d3) const noexcept
  {
    const double p = 2.0 * this->Exponent + 1.0;
    return (rho - x / (p + 2.0) * (d1 - x / (p + 3.0) * (d2 - x / (p + 4.0) * d3))) / (p + 1.0);
  }

  /// ρ = s^(-2m) F and its slope with respect to s, as in ResponseSampling.
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
  std::vector<Share> Left; ///< share of each sample in the preceding interval; unused for the first
  std::vector<Share> Right; ///< share of each sample in the next interval; unused for the last
};
} // namespace palpate

#endif
