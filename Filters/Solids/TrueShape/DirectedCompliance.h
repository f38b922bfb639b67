// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DirectedCompliance_h
#define palpate_DirectedCompliance_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

namespace palpate
{
/**
 * Compliance of a region of a surface by direction: the symmetric matrix Γ, mm/N. A force f moves
 * the region by Γ f, so that its compliance along a normal n is n·Γn. An ear, for example, is
 * compliant normal to its surface and stiff along it. The normals of neighbouring places differ,
 * and the compliances along them differ far more than Γ itself does between the places.
 *
 * Γ is a least-squares fit to motions g = Γ n under 1 N along the normals n of neighbouring places.
 * Γ is assumed to be the same at these places. Components of Γ that no normal determines are zero.
 */
class PALPATE_EXPORT DirectedCompliance
{
public:
  /// `normals` and `motions` (mm/N): one column per place. `weights`: positive, with sum 1. Without
  /// any column the result is zero.
  DirectedCompliance(const Eigen::Matrix3Xd& normals, const Eigen::Matrix3Xd& motions,
    const Eigen::VectorXd& weights);

  /// Returns n·Γn for a normal n, or for a mean of several normals.
  double along(const Eigen::Vector3d& normal) const { return normal.dot(this->Matrix * normal); }
  const Eigen::Matrix3d& matrix() const { return this->Matrix; }
  /// Γ in the coordinates of a frame, given by its columns.
  Eigen::Matrix3d inFrame(const Eigen::Matrix3d& frame) const
  {
    return frame.transpose() * this->Matrix * frame;
  }

private:
  Eigen::Matrix3d Matrix = Eigen::Matrix3d::Zero();
};
} // namespace palpate

#endif
