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
constexpr double LikelihoodRatio = 6.635; // χ² with one degree of freedom, 1 %
// Fractions of the largest force. LeastNoise: no law is more accurate, so that a smaller residual
// does not justify more parameters. LeastError: least noise for intervals, if the readings have no
// noise.
constexpr double LeastNoise = 0.003;
constexpr double LeastError = 0.0003;
constexpr int LargestPassCount = 6; // of alternating fits and choices of readings
// Sine of an angle; rounding and a kink can cause such an angle.
constexpr double Inseparable = 1e-4;
} // namespace FitLimits

/// Errors of the packed parameters from a Jacobian, per unit residual.
struct JacobianVerdict
{
  Eigen::VectorXd error;  ///< standard errors
  Eigen::MatrixXd spread; ///< S; S Sᵀ is their covariance; empty if they are not determined
  double separation = 0.0;
};
JacobianVerdict judgeJacobian(const Eigen::MatrixXd& jacobian);

/// Whether the residual of a fit is within the noise, by an F test at three standard deviations.
bool leavesNoise(const BodyFit& fit, const ForceNoise& noise);

/// The reason why a global compliance <= 0 is not accepted; "" if the compliance is positive.
/// `width` is the width of the interval, per standard error for a newton of noise, N.
std::string checkCompliance(const BodyFit& fit, double width);

/// The reason why an arranged curve determines no body, or "": its force does not rise, or its
/// depth is not plausible in mm.
std::string checkLoading(const IndentationCurve& curve);

/// The reason why the readings before contact of one of the curves of a fit are not a baseline, or
/// "". They are not on a straight line, within the noise or `allowed` (N), or the drift of the line
/// exceeds LargestDrift by more than its interval of the width `width`.
std::string checkBaseline(const std::vector<IndentationCurve>& curves, const BodyFit& fit,
  const ForceNoise& noise, double width, double allowed);

/// Whether the contact of a tool has the same radius at every depth.
bool isFlat(const AxisymmetricTool& tool);

/// The reason why curves of flat punches alone cannot be identified.
extern const char* const FlatAlone;
} // namespace palpate

#endif
