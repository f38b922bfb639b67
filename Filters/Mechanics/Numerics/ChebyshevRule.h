// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ChebyshevRule_h
#define palpate_ChebyshevRule_h

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <vector>
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Interpolation at the N Chebyshev points of the first kind on [-1, 1], in descending order, by the
 * barycentric formula (Berrut and Trefethen 2004, eqs. 4.2 and 5.3). Stable for any N.
 */
template <int N>
class ChebyshevRule
{
public:
  using Values = Eigen::Array<double, N, 1>;

  static const ChebyshevRule& standard()
  {
    static const ChebyshevRule rule(N);
    return rule;
  }

  const Values& points() const noexcept { return this->Points; }

  /// Returns the weight of each sample in the interpolant at t. The sum of the weights is 1.
  Values factorsAt(double t) const
  {
    const Values distance = t - this->Points;
    if ((distance == 0.0).any())
    {
      return (distance == 0.0).template cast<double>();
    }
    const Values factors = this->Weights / distance;
    return factors / factors.sum();
  }

  /// Creates a rule with `points` points. `points` must equal N unless N is Eigen::Dynamic.
  explicit ChebyshevRule(Eigen::Index points)
  {
    constexpr double pi = 3.14159265358979323846;
    this->Points.resize(points);
    this->Weights.resize(points);
    for (Eigen::Index i = 0; i < points; ++i)
    {
      const double angle = pi * (static_cast<double>(i) + 0.5) / static_cast<double>(points);
      this->Points[i] = std::cos(angle);
      this->Weights[i] = (i % 2 == 0 ? 1.0 : -1.0) * std::sin(angle);
    }
  }

private:
  Values Points;
  Values Weights;
};

/**
 * A function of one variable on [0, end], stored on pieces of equal length as Chebyshev series of
 * 16 terms each.
 *
 * If the function is analytic around each piece within a distance of the length of the piece, the
 * error is about 1e-13 of the magnitude of the function there.
 */
class PALPATE_EXPORT PiecewiseChebyshev
{
public:
  static constexpr int Terms = 16;

  PiecewiseChebyshev() = default;
  PiecewiseChebyshev(double end, int pieces, const std::function<double(double)>& function);

  /// Returns the function at x; 0 beyond the end. The functions stored in this way have decayed
  /// there.
  double evaluate(double x) const noexcept;

private:
  double PieceLength = 1.0;
  std::vector<double> Coefficients; ///< `Terms` coefficients per piece
};
} // namespace palpate

#endif
