// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactKernelFit_h
#define palpate_ContactKernelFit_h

#include "Mechanics/PalpateExport.h"
#include "Mechanics/TrueShape/RegularGreen.h"

namespace palpate
{
/**
 * What a body adds to the half-space under an axisymmetric contact of radius a, whatever the tool:
 * the regular part of the Green function, averaged over the angles of both points,
 *   H₀(r, ρ) = Σ c_mn (r/a)^{2m} (ρ/a)^{2n},  m, n < order,
 * and how far the surface falls off under it, angle mean, Σ d_m (r/a)^{2m}, m > 0.
 */
struct ContactKernel
{
  static constexpr int LargestOrder = 4;

  int order = 0;                ///< N; 0: there is none
  Eigen::Matrix4d coefficients; ///< c, mm/N, symmetric; zero beyond the order
  Eigen::Vector4d drop;         ///< d, mm; d₀ = 0
  double tilt = 0.0;            ///< β = |∇_s H₀| at X, 1/N: how the surface turns under 1 N
};

/**
 * Kernels at one point of a body, by least squares with polynomials in the tangent plane on both
 * sides. The disc follows the contact: points up to a count in full, and fade out by 1.3 a (about
 * 1.15 a in the mean), so that a growing contact takes in new points without a step. The degree is
 * 2(N-1): N = 2 from 9 points on, 3 from 21, 4 from 37, and less where these do not tell it. Of a
 * small contact the disc is that of the 9 nearest points, those under it with more weight. The
 * points are sources of the Green function, not all of the surface's where that was solved for
 * some; the drop is fitted to all.
 */
class PALPATE_EXPORT ContactKernelFit
{
public:
  /// `green` has been solved for `point`; it is not kept.
  ContactKernelFit(const RegularGreen& green, std::int32_t point);

  PatchStatus status() const { return this->Status; }
  double reducedModulus() const { return this->Modulus; } ///< E* at the point, MPa
  /// The largest contact radius: what was solved for, or up to the edge; and which of them it is.
  double largestRadius() const { return this->LargestRadius; }
  PatchStatus limitedBy() const { return this->LimitedBy; }
  /// How far the nearest edge, held point or other material is, and the nearest source, mm.
  double limit() const { return this->Limit; }
  double nearestSource() const
  {
    return this->Points.empty() ? 0.0 : this->Points.front().distance;
  }
  /// Distance of neighbouring nodes, mm.
  double spacing() const { return this->Spacing; }
  const ExpectedError& elementError() const { return this->ElementPart; }

  /// The kernel of the largest order that the points carry, but not above `largestOrder` >= 1. Of
  /// order 0 where the status is not valid, or for a radius that is none.
  ContactKernel at(double radius, int largestOrder = ContactKernel::LargestOrder) const;

  /// H between the points of the disc, symmetric, beside points(). For oracles.
  const Eigen::MatrixXd& values() const { return this->Values; }
  const std::vector<DiscPoint>& points() const { return this->Points; }
  /// The largest |H(x,y) - H(y,x)| of the disc over the largest |H|; a sign of elements too coarse
  /// near an edge, not an estimate of the error.
  double asymmetry() const { return this->Asymmetry; }

private:
  PatchStatus Status = PatchStatus::Degenerate;
  double Modulus = 0.0;
  double LargestRadius = 0.0;
  PatchStatus LimitedBy = PatchStatus::Valid;
  double Limit = Infinity;
  double Spacing = 0.0;
  ExpectedError ElementPart;
  double Asymmetry = 0.0;
  std::vector<DiscPoint> Points;  ///< sources
  std::vector<DiscPoint> Surface; ///< all; empty: the same
  Eigen::MatrixXd Values;
};
} // namespace palpate

#endif
