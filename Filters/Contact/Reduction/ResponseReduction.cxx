// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Reduction/ResponseReduction.h"

#include "Contact/Reduction/CurveError.h"
#include "Contact/Reduction/LeadingLaws.h"
#include "Contact/Reduction/ReducibleCurves.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr std::size_t ScreenSize = 4096; // number of points on which a form is tested first

/// Returns the values after rounding to float, as they are stored.
template <class Matrix>
Matrix stored(const Matrix& values)
{
  return values.template cast<float>().template cast<double>();
}

Eigen::VectorXd storedCoefficients(
  const ReducibleCurves& curves, std::size_t i, const Eigen::MatrixXd& laws)
{
  const Eigen::VectorXd curve = curves.curve(i);
  return stored(Eigen::VectorXd(
    lawCoefficients(curve, columnWeights(curve, curves.sampling(), curves.range(i)), laws)));
}

/// Returns the curve of point i, sampled at the depths of `sampling`.
Eigen::VectorXd resampled(
  const ReducibleCurves& curves, std::size_t i, const ResponseSampling& sampling)
{
  const Eigen::VectorXd curve = curves.curve(i);
  const SampledCurve right{ curve, curves.sampling() };
  const Eigen::Index n = sampling.samples();
  Eigen::VectorXd samples(2 * n);
  for (Eigen::Index k = 0; k < n; ++k)
  {
    const double range = curves.range(i);
    const ResponseValue value = right.evaluate(range, sampling.depth(static_cast<int>(k), range));
    samples[k] = value.force;
    samples[n + k] = value.stiffness;
  }
  return stored(samples);
}

/// Returns the largest error of the curves reduced(i) over all i. Some curves are tested first; if
/// they already exceed the tolerance, the other curves are not tested.
template <class Reduced>
CurveError errorOf(const ReducibleCurves& curves, const ResponseSampling& sampling,
  double tolerance, const Reduced& reduced)
{
  const auto add = [&](CurveError& error, std::size_t i)
  {
    const Eigen::VectorXd right = curves.curve(i);
    // Binding the result to a reference extends the lifetime of a temporary.
    const Eigen::VectorXd& other = reduced(i);
    error += curveError(
      { right, curves.sampling() }, { other, sampling }, curves.range(i), curves.point(i));
  };
  const std::size_t step = std::max<std::size_t>(1, curves.count() / ScreenSize);
  const CurveError screened = curves.sum(CurveError{}, add, step);
  return step == 1 || screened.force > tolerance ? screened : curves.sum(CurveError{}, add);
}

void note(ReducedResponse& result, const CurveError& error)
{
  result.largestError = error.force;
  result.largestSlopeError = error.slope;
  result.worstPoint = error.point;
}

/// Stores the laws as the rows of the array `basis`, and coefficients(i) for each point.
template <class Coefficients>
void storeLaws(ReducedResponse& result, const ResponseArrays& arrays, const ReducibleCurves& curves,
  const Eigen::MatrixXd& laws, const Coefficients& coefficients)
{
  const auto count = static_cast<std::size_t>(laws.cols());
  result.laws = static_cast<int>(count);
  result.samples = arrays.samples;
  const Eigen::MatrixXf basis = laws.cast<float>();
  result.basis.assign(basis.data(), basis.data() + basis.size()); // one law after the other
  result.coefficient.assign(count * arrays.points, 0.0F);
  forRanges(curves.count(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        float* row = result.coefficient.data() + count * curves.point(i);
        Eigen::Map<Eigen::VectorXf>(row, laws.cols()) =
          Eigen::VectorXd(coefficients(i)).template cast<float>();
      }
    });
}

/// Returns the law in the middle of all curves, which are multiples of one law.
Eigen::MatrixXd middleLaw(const ReducibleCurves& curves, const Eigen::MatrixXd& law)
{
  struct Span
  {
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    Span& operator+=(const Span& other)
    {
      this->least = std::min(this->least, other.least);
      this->most = std::max(this->most, other.most);
      return *this;
    }
  };
  const Span span = curves.sum(Span{},
    [&](Span& partial, std::size_t i)
    {
      const double scale = storedCoefficients(curves, i, law)[0];
      partial += { scale, scale };
    });
  // With the harmonic mean, the relative errors at both ends are equal.
  return stored(Eigen::MatrixXd(2.0 * span.least * span.most / (span.least + span.most) * law));
}

bool tryOneLaw(ReducedResponse& result, const ResponseArrays& arrays, const ReducibleCurves& curves,
  const Eigen::MatrixXd& law, double tolerance)
{
  const Eigen::MatrixXd middle = middleLaw(curves, law);
  const Eigen::VectorXd curve = middle.col(0);
  const CurveError error = errorOf(curves, curves.sampling(), tolerance,
    [&](std::size_t) -> const Eigen::VectorXd& { return curve; });
  if (!(error.force <= tolerance))
  {
    return false;
  }
  result.form = ReducedForm::OneLaw;
  result.numbersPerPoint = 0;
  storeLaws(result, arrays, curves, middle, [](std::size_t) { return Eigen::VectorXd::Ones(1); });
  note(result, error);
  return true;
}

bool tryLaws(ReducedResponse& result, const ResponseArrays& arrays, const ReducibleCurves& curves,
  const Eigen::MatrixXd& laws, double tolerance)
{
  const auto coefficients = [&](std::size_t i) { return storedCoefficients(curves, i, laws); };
  const CurveError error = errorOf(curves, curves.sampling(), tolerance,
    [&](std::size_t i) { return Eigen::VectorXd(laws * coefficients(i)); });
  if (!(error.force <= tolerance))
  {
    return false;
  }
  result.form = laws.cols() == 1 ? ReducedForm::Scale : ReducedForm::Basis;
  storeLaws(result, arrays, curves, laws, coefficients);
  result.numbersPerPoint = result.laws;
  note(result, error);
  return true;
}

bool trySamples(ReducedResponse& result, const ResponseArrays& arrays,
  const ReducibleCurves& curves, int samples, double tolerance)
{
  const ResponseSampling sampling(samples, arrays.exponent);
  const auto reduced = [&](std::size_t i) { return resampled(curves, i, sampling); };
  const CurveError error = errorOf(curves, sampling, tolerance, reduced);
  if (!(error.force <= tolerance))
  {
    return false;
  }
  const auto n = static_cast<std::size_t>(samples);
  result.form = ReducedForm::Samples;
  result.samples = samples;
  result.numbersPerPoint = 2 * samples;
  result.force.assign(n * arrays.points, 0.0F);
  result.stiffness.assign(n * arrays.points, 0.0F);
  forRanges(curves.count(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const Eigen::VectorXf row = reduced(i).cast<float>();
        std::copy_n(row.data(), n, result.force.data() + n * curves.point(i));
        std::copy_n(row.data() + n, n, result.stiffness.data() + n * curves.point(i));
      }
    });
  note(result, error);
  return true;
}
} // namespace

ReducedResponse reduceResponse(const ResponseArrays& arrays, const ReductionSettings& settings)
{
  ReducedResponse result;
  result.samples = arrays.samples;
  result.numbersPerPoint = arrays.basis ? arrays.laws : 2 * arrays.samples;
  const ReducibleCurves curves(arrays);
  if (curves.count() == 0)
  {
    return result;
  }
  const double tolerance = settings.tolerance;
  const int most = std::min(settings.mostLaws, result.numbersPerPoint - 1);
  const Eigen::MatrixXd laws = stored(leadingLaws(curves, std::max(most, 1)));
  if (tryOneLaw(result, arrays, curves, laws.leftCols(1), tolerance))
  {
    return result;
  }
  for (Eigen::Index k = 1; k <= std::min<Eigen::Index>(most, laws.cols()); ++k)
  {
    if (tryLaws(result, arrays, curves, laws.leftCols(k), tolerance))
    {
      return result;
    }
  }
  for (int samples = 2; 2 * samples < result.numbersPerPoint; ++samples)
  {
    if (trySamples(result, arrays, curves, samples, tolerance))
    {
      return result;
    }
  }
  return result;
}
} // namespace palpate
