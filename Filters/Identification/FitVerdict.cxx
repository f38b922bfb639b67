// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/FitVerdict.h"

#include "Identification/ArrangedReadings.h"
#include "Identification/CurveSigns.h"
#include "Mechanics/Files/NumberText.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

const char* const FlatAlone =
  "the curve of a flat punch is a straight line on any body: E* cannot be distinguished from the "
  "global compliance or the thickness; measure with a sphere as well";

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
  return "the fitted global compliance is " + shortly(compliance) +
    " mm/N, but that of a body is not negative: " +
    (most > 0.0 ? "a half-space explains the readings as well"
                : "the readings stiffen more than a half-space does");
}

std::string checkLoading(const IndentationCurve& curve)
{
  const double depth = curve.deflection.back() - curve.start.depth;
  return curve.start.modulus > 0.0 ? doubtUnits(*curve.tool, depth)
                                   : "the force does not increase with the depth: it goes from " +
      shortly(curve.force.front()) + " N to " + shortly(curve.force.back()) + " N";
}

std::string checkBaseline(const std::vector<IndentationCurve>& curves, const BodyFit& fit,
  const ForceNoise& noise, double width, double allowed)
{
  Eigen::Index next =
    (fit.body.model == BodyModel::HalfSpace ? 1 : 2) + static_cast<Eigen::Index>(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const auto terms = static_cast<int>(fit.terms[c]);
    if (terms == 0)
    {
      continue;
    }
    const IndentationCurve& curve = curves[c];
    const ForceBaseline& baseline = fit.baseline[c];
    const double depth = curve.deflection.back() - fit.contactOffset[c];
    const double drift =
      std::abs(baseline.drift) - (terms > 1 ? width * fit.errorPerNoise[next + 1] : 0.0);
    next += terms;
    if (drift * depth > LargestDrift * curve.largestForce())
    {
      return "before contact the force changes by " + shortly(baseline.drift) + " N per mm, " +
        inPercent(std::abs(baseline.drift) * depth / curve.largestForce()) +
        " of the largest force over the depth of contact: this is not a baseline";
    }
    double squares = 0.0;
    int freedom = -terms;
    for (std::size_t i = 0; i < curve.force.size() && curve.deflection[i] < fit.contactOffset[c];
         ++i)
    {
      const double left = curve.force[i] - baseline.at(curve.deflection[i]);
      squares += curve.readings[i] * left * left;
      ++freedom;
    }
    const double left = freedom > 0 ? std::sqrt(squares / freedom) : 0.0;
    const double ratio = left / noise.deviation;
    if (ratio * ratio >
        1.0 + 3.0 * std::sqrt(2.0 / std::max(freedom, 1) + 2.0 / noise.degreesOfFreedom) &&
      left > allowed)
    {
      return "the readings before contact leave " + shortly(left) +
        " N about a straight line, more than the noise of " + shortly(noise.deviation) +
        " N and the " + shortly(allowed) + " N allowed";
    }
  }
  return {};
}

bool isFlat(const AxisymmetricTool& tool)
{
  return !(tool.largestContactRadius() > tool.smallestContactRadius());
}
} // namespace palpate
