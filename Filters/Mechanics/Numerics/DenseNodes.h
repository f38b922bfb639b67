// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DenseNodes_h
#define palpate_DenseNodes_h

#include "Mechanics/Numerics/UnilateralContact.h"

#include <Eigen/Cholesky>

#include <utility>

namespace palpate
{
/// Nodes with a known compliance matrix, which is symmetric and positive definite.
class DenseNodes : public CompliantNodes
{
public:
  explicit DenseNodes(Eigen::MatrixXd compliance)
    : Compliance(std::move(compliance))
  {
  }

  void press(
    const std::vector<int>& active, const Eigen::VectorXd& wanted, Eigen::VectorXd& forces) override
  {
    forces.setZero(wanted.size());
    if (active.empty())
    {
      return;
    }
    const Eigen::MatrixXd some = this->Compliance(active, active);
    const Eigen::VectorXd right = wanted(active);
    const Eigen::VectorXd found = some.ldlt().solve(right);
    forces(active) = found;
  }

  void move(const std::vector<int>&, const Eigen::VectorXd& forces, Eigen::VectorXd& moved) override
  {
    moved = this->Compliance * forces;
  }

private:
  Eigen::MatrixXd Compliance;
};
} // namespace palpate

#endif
