// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactKernelFit_h
#define palpate_ContactKernelFit_h

#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/ContactKernels.h"

namespace palpate
{
/**
 * Kernels at one point of a body. They are least-squares fits of polynomials in the tangent plane
 * to both arguments of H. The fitted disc grows with the contact. Points up to the contact radius a
 * have full weight. The weight falls to zero at 1.3 a (the effective mean radius is about 1.15 a),
 * so that a growing contact includes new points without a jump. The degree is 2(N-1): N = 2 from 9
 * points, 3 from 21, 4 from 37, and N is smaller if these points do not determine the terms. A
 * small contact uses the disc of the 9 nearest points, with more weight on the points under the
 * contact. The points are sources of the Green function. If not all surface points are sources, the
 * drop of the surface below the tangent plane is still fitted to all surface points.
 */
class PALPATE_EXPORT ContactKernelFit : public ContactKernels
{
public:
  /// `green` must be solved for `point`. The object keeps no reference to `green`.
  ContactKernelFit(const RegularGreen& green, std::int32_t point);

  ContactKernel at(double radius, int largestOrder = ContactKernel::LargestOrder) const override;

  /// Returns H between points(), which is symmetric. It is used to check H against other methods.
  const Eigen::MatrixXd& values() const { return this->Values; }
  const std::vector<DiscPoint>& points() const { return this->Points; }
  /// Returns the largest |H(x,y) - H(y,x)| of the disc, divided by the largest |H|. A large value
  /// indicates that the elements near an edge are too coarse. The asymmetry is not an estimate of
  /// the error.
  double asymmetry() const { return this->Asymmetry; }

private:
  double Asymmetry = 0.0;
  std::vector<DiscPoint> Points;  ///< sources in the disc
  std::vector<DiscPoint> Surface; ///< all surface points; empty if they are the same as Points
  Eigen::Matrix3Xd Normals;       ///< one normal per point of Points
  Eigen::MatrixXd Values;
};
} // namespace palpate

#endif
