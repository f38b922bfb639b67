// SPDX-License-Identifier: BSD-3-Clause
#include "LoopPoles.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

namespace palpate::testing
{
namespace
{
Eigen::VectorXcd polesOf(const std::vector<double>& readings, int order)
{
  const auto count = static_cast<Eigen::Index>(readings.size());
  const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(readings.data(), count);
  const Eigen::VectorXd d = x.tail(count - 1) - x.head(count - 1);
  const Eigen::Index rows = d.size() - order;
  Eigen::MatrixXd past(rows, order);
  for (Eigen::Index i = 0; i < order; ++i)
  {
    past.col(i) = d.segment(i, rows);
  }
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(order, order);
  companion.diagonal(1).setOnes();
  // A fast pole soon decays below rounding. It is then left out, not estimated.
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-11);
  solver.compute(past);
  companion.row(order - 1) = solver.solve(d.tail(rows)).transpose();
  return companion.eigenvalues();
}
} // namespace

double largestPole(const std::vector<double>& readings, int order)
{
  return polesOf(readings, order).cwiseAbs().maxCoeff();
}

double largestSwingingPole(const std::vector<double>& readings, int order)
{
  double largest = 0.0;
  for (const std::complex<double>& pole : polesOf(readings, order))
  {
    largest = std::abs(std::arg(pole)) > 0.01 ? std::max(largest, std::abs(pole)) : largest;
  }
  return largest;
}
} // namespace palpate::testing
