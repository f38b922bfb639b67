// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LeadingLaws_h
#define palpate_LeadingLaws_h

#include "Contact/Reduction/ReducibleCurves.h"

namespace palpate
{
/**
 * What a relative error of each column of a curve does to the force around it: 1/F_i for forces;
 * for slopes what they move a Hermite cubic at most, 4/27 of slope times interval, over F_i.
 */
Eigen::VectorXd columnWeights(
  const Eigen::VectorXd& curve, const ResponseSampling& sampling, double range);

/**
 * Up to `most` laws, one per column, the most important first: the leading eigenvectors of the Gram
 * matrix of the curves, each over its force at full range, with columns weighted as above at their
 * mean. The first law is 1 N at full range. There must be curves, with positive forces.
 */
Eigen::MatrixXd leadingLaws(const ReducibleCurves& curves, int most);

/// The coefficients of the laws that make the curve, by weighted least squares.
Eigen::VectorXd lawCoefficients(
  const Eigen::VectorXd& curve, const Eigen::VectorXd& weights, const Eigen::MatrixXd& laws);
} // namespace palpate

#endif
