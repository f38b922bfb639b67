// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Reduction/LeadingLaws.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>

namespace palpate
{
Eigen::VectorXd columnWeights(
  const Eigen::VectorXd& curve, const ResponseSampling& sampling, double range)
{
  // The maximum of t (1 - t)² and of t² (1 - t) for t from 0 to 1.
  constexpr double slopeReach = 4.0 / 27.0;
  const Eigen::Index n = sampling.samples();
  Eigen::VectorXd weights(2 * n);
  double before = 0.0;
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const double depth = sampling.depth(static_cast<int>(i), range);
    weights[i] = 1.0 / std::max(curve[i], std::numeric_limits<double>::min());
    weights[n + i] = slopeReach * (depth - before) * weights[i];
    before = depth;
  }
  return weights;
}

Eigen::MatrixXd leadingLaws(const ReducibleCurves& curves, int most)
{
  const Eigen::Index n = curves.sampling().samples();
  const auto shape = [&](std::size_t i)
  {
    const Eigen::VectorXd curve = curves.curve(i);
    return Eigen::VectorXd(curve / curve[n - 1]);
  };
  const Eigen::VectorXd sum = curves.sum<Eigen::VectorXd>(Eigen::VectorXd::Zero(2 * n),
    [&](Eigen::VectorXd& partial, std::size_t i) { partial += shape(i); });
  const Eigen::VectorXd mean = sum / static_cast<double>(curves.count());
  const Eigen::VectorXd weights = columnWeights(mean, curves.sampling(), curves.range(0));
  const Eigen::MatrixXd gram = curves.sum<Eigen::MatrixXd>(Eigen::MatrixXd::Zero(2 * n, 2 * n),
    [&](Eigen::MatrixXd& partial, std::size_t i)
    {
      const Eigen::VectorXd weighted = shape(i).cwiseProduct(weights);
      partial.selfadjointView<Eigen::Lower>().rankUpdate(weighted);
    });
  // The eigenvalues are in ascending order.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(gram);
  const Eigen::Index count = std::min<Eigen::Index>(most, 2 * n);
  Eigen::MatrixXd laws =
    weights.cwiseInverse().asDiagonal() * modes.eigenvectors().rightCols(count).rowwise().reverse();
  laws.col(0) /= laws(n - 1, 0);
  for (Eigen::Index k = 1; k < count; ++k)
  {
    laws.col(k) /= std::copysign(laws.col(k).head(n).cwiseAbs().maxCoeff(), laws(0, k));
  }
  return laws;
}

Eigen::VectorXd lawCoefficients(
  const Eigen::VectorXd& curve, const Eigen::VectorXd& weights, const Eigen::MatrixXd& laws)
{
  const Eigen::MatrixXd weighted = weights.asDiagonal() * laws;
  return (weighted.transpose() * weighted)
    .ldlt()
    .solve(weighted.transpose() * curve.cwiseProduct(weights));
}
} // namespace palpate
