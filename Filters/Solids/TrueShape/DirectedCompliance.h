// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DirectedCompliance_h
#define palpate_DirectedCompliance_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

namespace palpate
{
/**
 * Compliance of a region of a surface for any direction of the force, as the symmetric matrix Γ,
 * mm/N. A force f moves the region by Γ f, so that the compliance along a normal n is n·Γn. An ear,
 * for example, is compliant normal to its surface and stiff along its surface. The normals at
 * neighbouring points differ, and the compliances along these normals differ far more than Γ does.
 *
 * Γ is a least-squares fit to motions g = Γ n under forces of 1 N along the normals n at
 * neighbouring points. Γ is assumed to be the same at these points. Components of Γ that no normal
 * determines are zero.
 */
class PALPATE_EXPORT DirectedCompliance
{
public:
  /// `normals` and `motions` (mm/N) have one column per point. `weights` are positive and have the
  /// sum 1. If there are no columns, Γ is zero.
  DirectedCompliance(const Eigen::Matrix3Xd& normals, const Eigen::Matrix3Xd& motions,
    const Eigen::VectorXd& weights);

  /// Returns n·Γn for a normal n, or for the mean n of several normals.
  double along(const Eigen::Vector3d& normal) const { return normal.dot(this->Matrix * normal); }
  const Eigen::Matrix3d& matrix() const { return this->Matrix; }
  /// Returns Γ in the coordinates of a frame, which is given by its columns.
  Eigen::Matrix3d inFrame(const Eigen::Matrix3d& frame) const
  {
    return frame.transpose() * this->Matrix * frame;
  }

private:
  Eigen::Matrix3d Matrix = Eigen::Matrix3d::Zero();
};
} // namespace palpate

#endif
