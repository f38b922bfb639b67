// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/FitVerdict.h"

#include <Eigen/QR>

#include <cmath>
#include <limits>

namespace palpate
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

const char* const FlatAlone =
  "a flat punch feels a straight line whatever the body: E* cannot be told from the global "
  "compliance or the thickness; measure with a sphere as well";

JacobianVerdict judgeJacobian(const MatrixXd& jacobian)
{
  const Eigen::Index n = jacobian.cols();
  const VectorXd length = jacobian.colwise().norm();
  JacobianVerdict verdict;
  verdict.error = VectorXd::Constant(n, std::numeric_limits<double>::infinity());
  if (!(length.minCoeff() > 0.0) || !jacobian.allFinite())
  {
    return verdict;
  }
  const MatrixXd unit = jacobian * length.cwiseInverse().asDiagonal();
  const MatrixXd r = MatrixXd(unit.householderQr().matrixQR().topRows(n));
  if (!(r.diagonal().cwiseAbs().minCoeff() > 0.0))
  {
    return verdict;
  }
  const MatrixXd inverse =
    r.triangularView<Eigen::Upper>().solve(MatrixXd(MatrixXd::Identity(n, n)));
  const VectorXd error = inverse.rowwise().norm();
  verdict.separation = 1.0 / error.maxCoeff();
  verdict.error = error.cwiseQuotient(length);
  verdict.spread = length.cwiseInverse().asDiagonal() * inverse;
  return verdict;
}

bool leavesNoise(const BodyFit& fit, const ForceNoise& noise)
{
  const double ratio = fit.residual() / noise.deviation;
  const double spread = 2.0 / fit.degreesOfFreedom + 2.0 / noise.degreesOfFreedom;
  return ratio * ratio <= 1.0 + 3.0 * std::sqrt(spread);
}

bool isFlat(const AxisymmetricTool& tool)
{
  return !(tool.largestContactRadius() > tool.smallestContactRadius());
}
} // namespace palpate
