// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Numerics/GaussLegendre.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace palpate
{
GaussLegendre::GaussLegendre(int nodes)
{
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(nodes);
  Eigen::VectorXd offDiagonal(nodes - 1);
  for (int k = 1; k < nodes; ++k)
  {
    offDiagonal[k - 1] = k / std::sqrt(4.0 * k * k - 1.0);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, offDiagonal);
  const Eigen::ArrayXd x = solver.eigenvalues().array();
  const Eigen::ArrayXd w = 2.0 * solver.eigenvectors().row(0).array().square();
  this->Nodes = 0.5 * (x - x.reverse());
  this->Weights = 0.5 * (w + w.reverse());
}

const GaussLegendre& GaussLegendre::standard()
{
  static const GaussLegendre rule(64);
  return rule;
}
} // namespace palpate
