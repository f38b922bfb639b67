// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_NonNegativeLeastSquares_h
#define palpate_NonNegativeLeastSquares_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

namespace palpate
{
/// Returns the x >= 0 that minimises |A x - b| (Lawson and Hanson 1974, chapter 23). A must have at
/// least as many rows as columns, and columns of similar length.
PALPATE_EXPORT Eigen::VectorXd nonNegativeLeastSquares(
  const Eigen::MatrixXd& A, const Eigen::VectorXd& b);
} // namespace palpate

#endif
