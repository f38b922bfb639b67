// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactKernelFit_h
#define palpate_ContactKernelFit_h

#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/ContactKernels.h"

namespace palpate
{
/**
 * Kernels at one point of a body, by least squares with polynomials in the tangent plane on both
 * sides. The disc follows the contact: points up to a count in full, and fade out by 1.3 a (about
 * 1.15 a in the mean), so that a growing contact takes in new points without a step. The degree is
 * 2(N-1): N = 2 from 9 points on, 3 from 21, 4 from 37, and less where these do not tell it. Of a
 * small contact the disc is that of the 9 nearest points, those under it with more weight. The
 * points are sources of the Green function, not all of the surface's where that was solved for
 * some; the drop is fitted to all.
 */
class PALPATE_EXPORT ContactKernelFit : public ContactKernels
{
public:
  /// `green` has been solved for `point`; it is not kept.
  ContactKernelFit(const RegularGreen& green, std::int32_t point);

  ContactKernel at(double radius, int largestOrder = ContactKernel::LargestOrder) const override;

  /// H between the points of the disc, symmetric, beside points(). For oracles.
  const Eigen::MatrixXd& values() const { return this->Values; }
  const std::vector<DiscPoint>& points() const { return this->Points; }
  /// The largest |H(x,y) - H(y,x)| of the disc over the largest |H|; a sign of elements too coarse
  /// near an edge, not an estimate of the error.
  double asymmetry() const { return this->Asymmetry; }

private:
  double Asymmetry = 0.0;
  std::vector<DiscPoint> Points;  ///< sources
  std::vector<DiscPoint> Surface; ///< all; empty: the same
  Eigen::Matrix3Xd Normals;       ///< beside Points
  Eigen::MatrixXd Values;
};
} // namespace palpate

#endif
