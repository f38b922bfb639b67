// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LeadingLaws_h
#define palpate_LeadingLaws_h

#include "Contact/Reduction/ReducibleCurves.h"

namespace palpate
{
/**
 * Returns the largest relative error of the force that a unit error in each column of a curve
 * causes. For a force F_i it is 1/F_i. For a slope it is the largest change of a Hermite cubic
 * (4/27 of the slope times the interval), divided by F_i.
 */
Eigen::VectorXd columnWeights(
  const Eigen::VectorXd& curve, const ResponseSampling& sampling, double range);

/**
 * Returns up to `most` laws, one per column, the most important first. They are the leading
 * eigenvectors of the Gram matrix of the curves. Each curve is divided by its force at full range,
 * and the columns are weighted by columnWeights() of the mean curve. The first law is scaled to 1 N
 * at full range. There must be at least one curve, and all forces must be positive.
 */
Eigen::MatrixXd leadingLaws(const ReducibleCurves& curves, int most);

/// Returns the coefficients of the laws for a curve, by weighted least squares.
Eigen::VectorXd lawCoefficients(
  const Eigen::VectorXd& curve, const Eigen::VectorXd& weights, const Eigen::MatrixXd& laws);
} // namespace palpate

#endif
