// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_GaussLegendre_h
#define palpate_GaussLegendre_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

namespace palpate
{
/**
 * Gauss-Legendre quadrature: ∫_a^b f(x) dx ≈ Σ w_i f(x_i), exact for polynomials up to degree 2n-1.
 *
 * Nodes and weights are the eigenvalues and first eigenvector components of the Legendre Jacobi
 * matrix (Golub and Welsch 1969), symmetrised about zero.
 */
class PALPATE_EXPORT GaussLegendre
{
public:
  explicit GaussLegendre(int nodes);

  /// The 64-point rule for the contact integrals. Its error is 1e-11 for an analytic integrand
  /// whose nearest singularity is at least 1 % of the interval beyond the end of the interval.
  static const GaussLegendre& standard();

  /// The nodes on [-1, 1], ascending.
  const Eigen::ArrayXd& nodes() const noexcept { return this->Nodes; }
  const Eigen::ArrayXd& weights() const noexcept { return this->Weights; }

  template <class Function>
  double integrate(double a, double b, Function&& f) const
  {
    const double centre = 0.5 * (a + b);
    const double half = 0.5 * (b - a);
    double sum = 0.0;
    for (Eigen::Index i = 0; i < this->Nodes.size(); ++i)
    {
      sum += this->Weights[i] * f(centre + half * this->Nodes[i]);
    }
    return half * sum;
  }

private:
  Eigen::ArrayXd Nodes;
  Eigen::ArrayXd Weights;
};
} // namespace palpate

#endif
