// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/DirectedCompliance.h"

#include <Eigen/Cholesky>

namespace palpate
{
namespace
{
/// Regularisation relative to the sum of the weights. Components of Γ that depend on very small
/// differences of the normals become nearly zero. Other components are slightly reduced.
constexpr double Damping = 1e-3;

using Entries = Eigen::Matrix<double, 6, 1>; ///< The entries xx, yy, zz, yz, xz, xy of Γ.

/// Returns the matrix that maps the entries of Γ to Γ n.
Eigen::Matrix<double, 3, 6> motionOfEntries(const Eigen::Vector3d& n)
{
  Eigen::Matrix<double, 3, 6> rows;
  rows << n[0], 0.0, 0.0, 0.0, n[2], n[1], //
    0.0, n[1], 0.0, n[2], 0.0, n[0],       //
    0.0, 0.0, n[2], n[1], n[0], 0.0;
  return rows;
}
} // namespace

DirectedCompliance::DirectedCompliance(
  const Eigen::Matrix3Xd& normals, const Eigen::Matrix3Xd& motions, const Eigen::VectorXd& weights)
{
  Eigen::Matrix<double, 6, 6> system = Damping * Eigen::Matrix<double, 6, 6>::Identity();
  Entries right = Entries::Zero();
  for (Eigen::Index i = 0; i < weights.size(); ++i)
  {
    const Eigen::Matrix<double, 3, 6> rows = motionOfEntries(normals.col(i));
    system += weights[i] * rows.transpose() * rows;
    right += weights[i] * rows.transpose() * motions.col(i);
  }
  const Entries found = system.llt().solve(right);
  this->Matrix << found[0], found[5], found[4], //
    found[5], found[1], found[3],               //
    found[4], found[3], found[2];
}
} // namespace palpate
