// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FitVerdict_h
#define palpate_FitVerdict_h

#include "Identification/BodyFit.h"
#include "Identification/ForceNoise.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace palpate
{
/// Limits for judging the fits of bodies.
namespace FitLimits
{
constexpr double LikelihoodRatio = 6.635; // 1 % limit of χ² with one degree of freedom
// The following values are fractions of the largest force. `LeastNoise`: a smaller residual does
// not justify more parameters, because no law is more accurate. `LeastError`: smallest noise
// assumed for confidence intervals, used if the readings have no noise.
constexpr double LeastNoise = 0.003;
constexpr double LeastError = 0.0003;
// Largest number of alternations between a fit and a selection of readings.
constexpr int LargestPassCount = 6;
// Limit of BodyFit::separation (sine of an angle). Rounding errors and a kink can cause an angle of
// this size.
constexpr double Inseparable = 1e-4;
} // namespace FitLimits

/// Errors of the packed parameters for a unit residual, computed from a Jacobian.
struct JacobianVerdict
{
  Eigen::VectorXd error; ///< standard errors
  /// S, where S Sᵀ is the covariance; empty if the parameters are not determined.
  Eigen::MatrixXd spread;
  double separation = 0.0;
};
JacobianVerdict judgeJacobian(const Eigen::MatrixXd& jacobian);

/// Returns whether the residual of a fit is within the noise, by an F test at three standard
/// deviations.
bool leavesNoise(const BodyFit& fit, const ForceNoise& noise);

/// Returns the reason why a global compliance <= 0 is not accepted; "" if the compliance is
/// positive. `width` is the result of intervalWidth(), N.
std::string checkCompliance(const BodyFit& fit, double width);

/// Returns the reason why an arranged curve does not determine a body, or "". Possible reasons are
/// a force that does not increase, and a depth that is not plausible in mm.
std::string checkLoading(const IndentationCurve& curve);

/// Returns the reason why the readings before contact of one of the fitted curves are not a
/// baseline, or "". Possible reasons: the readings are not on a straight line within the noise or
/// within `allowed` (N); or the drift of the line exceeds LargestDrift by more than its confidence
/// interval, which follows from `width` (intervalWidth(), N).
std::string checkBaseline(const std::vector<IndentationCurve>& curves, const BodyFit& fit,
  const ForceNoise& noise, double width, double allowed);

/// Returns whether the contact of a tool has the same radius at every depth.
bool isFlat(const AxisymmetricTool& tool);

/// The message for curves of flat punches alone, which do not identify a body.
extern const char* const FlatAlone;
} // namespace palpate

#endif
