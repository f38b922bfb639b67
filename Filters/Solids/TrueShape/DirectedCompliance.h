// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DirectedCompliance_h
#define palpate_DirectedCompliance_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

namespace palpate
{
/**
 * How a region of a surface yields by its direction: the symmetric Γ, mm/N, by which a force f
 * moves it by Γ f, so that its compliance along a normal n is n·Γn. An ear is soft across and stiff
 * along: the normals of neighbouring places differ, and so do their compliances, by far more than
 * the body does between them.
 *
 * By least squares of motions g = Γ n of 1 N along normals n at places near each other, which the
 * body is taken to be alike at. What no normal tells of Γ is taken for nothing.
 */
class PALPATE_EXPORT DirectedCompliance
{
public:
  /// A normal and its motion, mm/N, a column each; `weights`: positive, of sum 1. No column at all
  /// gives zero.
  DirectedCompliance(const Eigen::Matrix3Xd& normals, const Eigen::Matrix3Xd& motions,
    const Eigen::VectorXd& weights);

  /// n·Γn for a normal, or a mean of some.
  double along(const Eigen::Vector3d& normal) const { return normal.dot(this->Matrix * normal); }
  const Eigen::Matrix3d& matrix() const { return this->Matrix; }
  /// The same along the columns of a frame.
  Eigen::Matrix3d inFrame(const Eigen::Matrix3d& frame) const
  {
    return frame.transpose() * this->Matrix * frame;
  }

private:
  Eigen::Matrix3d Matrix = Eigen::Matrix3d::Zero();
};
} // namespace palpate

#endif
