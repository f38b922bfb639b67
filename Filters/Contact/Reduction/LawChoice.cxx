// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Reduction/LawChoice.h"

#include "Contact/Reduction/CurveError.h"
#include "Contact/Reduction/LeadingLaws.h"

#include <algorithm>
#include <cstring>

namespace palpate
{
namespace
{
constexpr std::size_t SampleSize = 8192;

/// Returns the values after rounding to float, as they are stored.
template <class Matrix>
Matrix asStored(const Matrix& values)
{
  return values.template cast<float>().template cast<double>();
}

/// Number of curves within the tolerance, and the largest error. += combines two sets of curves.
struct Kept
{
  std::size_t count = 0;
  double largest = 0.0;

  void add(double error, double tolerance)
  {
    this->count += error <= tolerance ? 1 : 0;
    this->largest = std::max(this->largest, error);
  }
  Kept& operator+=(const Kept& other)
  {
    this->count += other.count;
    this->largest = std::max(this->largest, other.largest);
    return *this;
  }
  bool suffices(std::size_t all, double share) const
  {
    return static_cast<double>(this->count) >= share * static_cast<double>(all);
  }
};

/// The arrays of at most 2 SampleSize points, evenly spaced among all points.
class SampledPoints
{
public:
  SampledPoints(const ResponseArrays& all, const ReducibleCurves& curves)
    : Arrays(all)
  {
    const std::size_t step = std::max<std::size_t>(1, curves.count() / SampleSize);
    const auto columns = static_cast<std::size_t>(all.basis ? all.laws : all.samples);
    const auto append = [&](std::vector<float>& rows, const float* from, std::size_t point)
    { rows.insert(rows.end(), from + columns * point, from + columns * (point + 1)); };
    for (std::size_t i = 0; i < curves.count(); i += step)
    {
      const std::size_t p = curves.point(i);
      append(this->First, all.basis ? all.coefficient : all.force, p);
      append(this->Second, all.basis ? all.coefficient : all.stiffness, p);
      this->Range.push_back(all.range[p]);
      this->Status.push_back(all.status[p]);
    }
    this->Arrays.points = this->Range.size();
    this->Arrays.range = this->Range.data();
    this->Arrays.status = this->Status.data();
    (all.basis ? this->Arrays.coefficient : this->Arrays.force) = this->First.data();
    this->Arrays.stiffness = this->Second.data();
  }
  SampledPoints(const SampledPoints&) = delete;
  SampledPoints& operator=(const SampledPoints&) = delete;

  const ResponseArrays& arrays() const { return this->Arrays; }

private:
  std::vector<float> First;
  std::vector<float> Second;
  std::vector<float> Range;
  std::vector<std::uint8_t> Status;
  ResponseArrays Arrays;
};

/// Returns the error of a curve with its best coefficients after rounding to float.
double fit(const ReducibleCurves& curves, std::size_t i, const Eigen::MatrixXd& laws,
  Eigen::VectorXd& coefficients)
{
  const Eigen::VectorXd curve = curves.curve(i);
  const double range = curves.range(i);
  const Eigen::VectorXd weights = columnWeights(curve, curves.sampling(), range);
  coefficients = asStored(Eigen::VectorXd(lawCoefficients(curve, weights, laws)));
  const Eigen::VectorXd reduced = laws * coefficients;
  return curveError({ curve, curves.sampling() }, { reduced, curves.sampling() }, range, 0).force;
}

/// Returns the multiple of a law that is in the middle of the curves. At each end of the
/// distribution, a fraction (1 - share)/2 of the curves is ignored.
Eigen::MatrixXd middleLaw(const ReducibleCurves& sample, const Eigen::MatrixXd& law, double share)
{
  std::vector<double> scales(sample.count());
  for (std::size_t i = 0; i < scales.size(); ++i)
  {
    Eigen::VectorXd scale;
    fit(sample, i, law, scale);
    scales[i] = scale[0];
  }
  std::sort(scales.begin(), scales.end());
  const auto out =
    static_cast<std::size_t>(0.5 * (1.0 - share) * static_cast<double>(scales.size() - 1));
  const double least = scales[out];
  const double most = scales[scales.size() - 1 - out];
  // With the harmonic mean, the relative errors at both ends are equal.
  return asStored(Eigen::MatrixXd(2.0 * least * most / (least + most) * law));
}

/// Returns whether all points have the same curve and range, bit for bit.
bool isOneCurve(const ResponseArrays& arrays, const ReducibleCurves& curves)
{
  const auto columns = static_cast<std::size_t>(arrays.basis ? arrays.laws : arrays.samples);
  const float* const first = arrays.basis ? arrays.coefficient : arrays.force;
  const float* const second = arrays.basis ? arrays.coefficient : arrays.stiffness;
  const std::size_t at = columns * curves.point(0);
  const auto isSame = [&](const float* rows, std::size_t i) {
    return std::memcmp(rows + columns * curves.point(i), rows + at, columns * sizeof(float)) == 0;
  };
  for (std::size_t i = 1; i < curves.count(); ++i)
  {
    if (curves.range(i) != curves.range(0) || !isSame(first, i) || !isSame(second, i))
    {
      return false;
    }
  }
  return true;
}

/// Returns the number of curves that the laws reproduce within the tolerance, and the largest
/// error. errorOf(curves, i, coefficients) computes the coefficients and returns the error; use(i,
/// coefficients) receives the coefficients.
template <class Error, class Use>
Kept keptOf(const ReducibleCurves& curves, double tolerance, const Error& errorOf, const Use& use)
{
  return curves.sum(Kept{},
    [&](Kept& sum, std::size_t i)
    {
      Eigen::VectorXd coefficients;
      sum.add(errorOf(curves, i, coefficients), tolerance);
      use(i, coefficients);
    });
}

/// Stores the laws in `choice` if the required fraction of the points is within the tolerance. The
/// sample is tested first, then all points.
template <class Error>
bool takeLaws(ResponseChoice& choice, const ResponseArrays& arrays, const ReducibleCurves& curves,
  const ReducibleCurves& sample, const Eigen::MatrixXd& laws, const ChoiceSettings& settings,
  const Error& errorOf)
{
  const auto ignore = [](std::size_t, const Eigen::VectorXd&) {};
  if (!keptOf(sample, settings.tolerance, errorOf, ignore).suffices(sample.count(), settings.share))
  {
    return false;
  }
  const auto count = static_cast<std::size_t>(laws.cols());
  std::vector<float> rows(count * arrays.points, 0.0F);
  const auto store = [&](std::size_t i, const Eigen::VectorXd& coefficients)
  {
    Eigen::Map<Eigen::VectorXf>(rows.data() + count * curves.point(i), laws.cols()) =
      coefficients.cast<float>();
  };
  const Kept kept = keptOf(curves, settings.tolerance, errorOf, store);
  if (!kept.suffices(curves.count(), settings.share))
  {
    return false;
  }
  const Eigen::MatrixXf basis = laws.cast<float>();
  choice.basis.assign(basis.data(), basis.data() + basis.size()); // one law after the other
  choice.coefficient = std::move(rows);
  choice.laws = static_cast<int>(count);
  choice.keptShare = static_cast<double>(kept.count) / static_cast<double>(curves.count());
  choice.largestError = kept.largest;
  return true;
}

void takeTheCurve(
  ResponseChoice& choice, const ResponseArrays& arrays, const ReducibleCurves& curves)
{
  const Eigen::VectorXf law = curves.curve(0).cast<float>();
  choice.need = ResponseNeed::OneLaw;
  choice.laws = 1;
  choice.numbersPerPoint = 0;
  choice.basis.assign(law.data(), law.data() + law.size());
  choice.coefficient.assign(arrays.points, 0.0F);
  for (std::size_t i = 0; i < curves.count(); ++i)
  {
    choice.coefficient[curves.point(i)] = 1.0F;
  }
}
} // namespace

bool chooseLaws(ResponseChoice& choice, const ResponseArrays& arrays, const ReducibleCurves& curves,
  const ChoiceSettings& settings)
{
  if (isOneCurve(arrays, curves))
  {
    takeTheCurve(choice, arrays, curves);
    return true;
  }
  const SampledPoints some(arrays, curves);
  const ReducibleCurves sample(some.arrays());
  const int most = std::min(settings.mostLaws, choice.numbersPerPoint - 1);
  const Eigen::MatrixXd laws = asStored(leadingLaws(sample, std::max(most, 1)));
  if (!laws.allFinite())
  {
    return false; // the forces are zero or not finite
  }
  const Eigen::MatrixXd one = middleLaw(sample, laws.leftCols(1), settings.share);
  const Eigen::VectorXd law = one.col(0);
  const auto errorOfOne = [&](const ReducibleCurves& of, std::size_t i, Eigen::VectorXd& unit)
  {
    unit = Eigen::VectorXd::Ones(1);
    const Eigen::VectorXd curve = of.curve(i);
    return curveError({ curve, of.sampling() }, { law, of.sampling() }, of.range(i), 0).force;
  };
  if (takeLaws(choice, arrays, curves, sample, one, settings, errorOfOne))
  {
    choice.need = ResponseNeed::OneLaw;
    choice.numbersPerPoint = 0;
    return true;
  }
  for (Eigen::Index k = 1; k <= std::min<Eigen::Index>(most, laws.cols()); ++k)
  {
    const Eigen::MatrixXd few = laws.leftCols(k);
    const auto errorOf = [&](const ReducibleCurves& of, std::size_t i, Eigen::VectorXd& values)
    { return fit(of, i, few, values); };
    if (takeLaws(choice, arrays, curves, sample, few, settings, errorOf))
    {
      choice.need = k == 1 ? ResponseNeed::ScaledLaw : ResponseNeed::FewLaws;
      choice.numbersPerPoint = choice.laws;
      return true;
    }
  }
  return false;
}
} // namespace palpate
