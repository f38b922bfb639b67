// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/FitVerdict.h"

#include "Mechanics/Files/NumberText.h"

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

std::string checkCompliance(const BodyFit& fit, double width)
{
  const double compliance = fit.body.compliance;
  if (fit.body.model != BodyModel::GlobalCompliance || compliance > 0.0)
  {
    return {};
  }
  const double most = compliance + width * fit.errorPerNoise[1];
  return "the global compliance comes out as " + shortly(compliance) +
    " mm/N, and no body has less than 0: " +
    (most > 0.0 ? "a half-space explains the readings as well"
                : "the readings stiffen more than a half-space does");
}

bool isFlat(const AxisymmetricTool& tool)
{
  return !(tool.largestContactRadius() > tool.smallestContactRadius());
}
} // namespace palpate
