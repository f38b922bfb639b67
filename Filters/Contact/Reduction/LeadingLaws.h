// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LeadingLaws_h
#define palpate_LeadingLaws_h

#include "Contact/Reduction/ReducibleCurves.h"

namespace palpate
{
/**
 * The largest relative error of the force that a unit error of each column of a curve causes: 1/F_i
 * for forces; for slopes the largest change of a Hermite cubic, 4/27 of slope times interval,
 * divided by F_i.
 */
Eigen::VectorXd columnWeights(
  const Eigen::VectorXd& curve, const ResponseSampling& sampling, double range);

/**
 * Up to `most` laws, one per column, the most important first: the leading eigenvectors of the Gram
 * matrix of the curves. Each curve is divided by its force at full range, and the columns are
 * weighted by columnWeights() of the mean curve. The first law is scaled to 1 N at full range.
 * There must be at least one curve, and forces must be positive.
 */
Eigen::MatrixXd leadingLaws(const ReducibleCurves& curves, int most);

/// The coefficients of the laws for the curve, by weighted least squares.
Eigen::VectorXd lawCoefficients(
  const Eigen::VectorXd& curve, const Eigen::VectorXd& weights, const Eigen::MatrixXd& laws);
} // namespace palpate

#endif
