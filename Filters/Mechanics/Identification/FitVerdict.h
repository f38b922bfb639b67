// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FitVerdict_h
#define palpate_FitVerdict_h

#include "Mechanics/Identification/BodyFit.h"
#include "Mechanics/Identification/ForceNoise.h"

#include <Eigen/Core>

namespace palpate
{
/// What the fits of bodies are judged by.
namespace FitLimits
{
constexpr double LikelihoodRatio = 6.635; // χ² with one degree of freedom, 1 %
constexpr double LeastNoise = 0.003;      // of the largest force: no law is truer, nor instrument
constexpr int LargestPassCount = 6;       // of fit and choice of readings in turns
constexpr double Inseparable = 1e-4;      // sine of an angle that rounding and a kink can give
} // namespace FitLimits

/// What a Jacobian says of the packed parameters, per unit residual.
struct JacobianVerdict
{
  Eigen::VectorXd error;  ///< standard errors
  Eigen::MatrixXd spread; ///< S, S Sᵀ their covariance; empty where they are not determined
  double separation = 0.0;
};
JacobianVerdict judgeJacobian(const Eigen::MatrixXd& jacobian);

/// Whether a fit leaves no more than noise: an F test at three standard deviations.
bool leavesNoise(const BodyFit& fit, const ForceNoise& noise);

/// Whether the contact of a tool is as wide at every depth.
bool isFlat(const AxisymmetricTool& tool);

/// Why nothing can come of what flat punches alone have felt.
extern const char* const FlatAlone;
} // namespace palpate

#endif
