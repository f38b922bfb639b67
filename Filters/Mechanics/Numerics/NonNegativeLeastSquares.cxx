// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Numerics/NonNegativeLeastSquares.h"

#include <Eigen/QR>

#include <algorithm>
#include <vector>

namespace palpate
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
/// Returns the least-squares solution for the free columns; the other coefficients are 0.
VectorXd solveFree(const MatrixXd& A, const VectorXd& b, const std::vector<bool>& free)
{
  std::vector<Index> columns;
  for (Index j = 0; j < A.cols(); ++j)
  {
    if (free[static_cast<std::size_t>(j)])
    {
      columns.push_back(j);
    }
  }
  MatrixXd some(A.rows(), static_cast<Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    some.col(static_cast<Index>(k)) = A.col(columns[k]);
  }
  const VectorXd found = some.colPivHouseholderQr().solve(b);
  VectorXd x = VectorXd::Zero(A.cols());
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    x[columns[k]] = found[static_cast<Index>(k)];
  }
  return x;
}
} // namespace

VectorXd nonNegativeLeastSquares(const MatrixXd& A, const VectorXd& b)
{
  const Index n = A.cols();
  const double enough = 1e-10 * A.norm() * b.norm();
  std::vector<bool> free(static_cast<std::size_t>(n), false);
  VectorXd x = VectorXd::Zero(n);
  for (Index round = 0; round < 3 * n; ++round)
  {
    const VectorXd gain = A.transpose() * (b - A * x);
    Index best = -1;
    for (Index j = 0; j < n; ++j)
    {
      const bool bound = !free[static_cast<std::size_t>(j)];
      best = bound && gain[j] > enough && (best < 0 || gain[j] > gain[best]) ? j : best;
    }
    if (best < 0)
    {
      break;
    }
    free[static_cast<std::size_t>(best)] = true;
    for (Index inner = 0; inner < n; ++inner)
    {
      const VectorXd wanted = solveFree(A, b, free);
      double share = 1.0; // fraction of the step at which the first value becomes negative
      for (Index j = 0; j < n; ++j)
      {
        if (free[static_cast<std::size_t>(j)] && wanted[j] <= 0.0)
        {
          share = std::min(share, x[j] > 0.0 ? x[j] / (x[j] - wanted[j]) : 0.0);
        }
      }
      x += share * (wanted - x);
      if (share == 1.0)
      {
        break;
      }
      for (Index j = 0; j < n; ++j)
      {
        if (free[static_cast<std::size_t>(j)] && x[j] <= 1e-14 * x.maxCoeff())
        {
          free[static_cast<std::size_t>(j)] = false;
          x[j] = 0.0;
        }
      }
    }
  }
  return x;
}
} // namespace palpate
