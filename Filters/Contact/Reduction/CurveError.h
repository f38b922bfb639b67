// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CurveError_h
#define palpate_CurveError_h

#include "Contact/ResponseSampling.h"

#include <Eigen/Core>

#include <cstddef>

namespace palpate
{
/// A curve as a vector of n forces, followed by n stiffnesses.
struct SampledCurve
{
  const Eigen::VectorXd& columns;
  const ResponseSampling& sampling;

  double force(int i) const noexcept { return columns[i]; }
  double stiffness(int i) const noexcept { return columns[sampling.samples() + i]; }
  ResponseValue evaluate(double range, double deflection) const noexcept
  {
    return sampling.evaluate(*this, range, deflection);
  }
};

/// The largest error of several curves, and the point at which it occurs. += keeps the larger
/// error; of two equal errors it keeps the first.
struct CurveError
{
  /// |F' - F|/F, with F_1 instead of F before the first sample; infinite if a value is not finite.
  double force = 0.0;
  double slope = 0.0; ///< |K' - K| divided by the largest K of the curve
  std::size_t point = 0;

  CurveError& operator+=(const CurveError& other)
  {
    this->slope = other.slope > this->slope ? other.slope : this->slope;
    if (other.force > this->force)
    {
      this->force = other.force;
      this->point = other.point;
    }
    return *this;
  }
};

/// Returns the error of a curve, evaluated at four depths in each interval between the samples of
/// `right`.
CurveError curveError(
  const SampledCurve& right, const SampledCurve& reduced, double range, std::size_t point);
} // namespace palpate

#endif
