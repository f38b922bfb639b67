// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LeastSquares_h
#define palpate_LeastSquares_h

#include <Eigen/Core>
#include <unsupported/Eigen/NonLinearOptimization>

namespace palpate
{
struct Minimum
{
  double squares;
  bool converged;
};

/// Moves p to the nearest minimum of the sum of squares (Levenberg and Marquardt). `tolerance` is
/// the relative tolerance of a step. `evaluations` is the largest number of evaluations.
template <class Residuals>
Minimum minimize(Residuals& residuals, Eigen::VectorXd& p, double tolerance, int evaluations = 200)
{
  using Status = Eigen::LevenbergMarquardtSpace::Status;
  Eigen::LevenbergMarquardt<Residuals> method(residuals);
  method.parameters.ftol = 1e-2 * tolerance;
  method.parameters.xtol = tolerance;
  method.parameters.maxfev = evaluations;
  const Status status = method.minimize(p);
  return { method.fvec.squaredNorm(),
    status != Status::TooManyFunctionEvaluation && status != Status::ImproperInputParameters };
}
} // namespace palpate

#endif
