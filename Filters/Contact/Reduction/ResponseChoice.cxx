// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Reduction/ResponseChoice.h"

#include "Mechanics/ContactRegime.h"
#include "Contact/Reduction/CurveError.h"
#include "Contact/Reduction/LawChoice.h"
#include "Contact/Reduction/ReducibleCurves.h"
#include "Contact/ResponseContract.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
/// Evaluates regime, validity, depths and ranges of the points that have a response.
void lookAtPoints(ResponseChoice& choice, const ReducibleCurves& curves,
  const ChoiceEvidence& evidence, const ChoiceSettings& settings)
{
  std::size_t shapeless = 0;
  std::size_t beyond = 0;
  std::array<std::size_t, ResponseLimitCount> limits{};
  for (std::size_t i = 0; i < curves.count(); ++i)
  {
    const std::size_t p = curves.point(i);
    const double range = curves.range(i);
    const double depth = settings.depth > 0.0 ? settings.depth : 0.5 * range;
    choice.range.add(range, i == 0);
    choice.depth.add(depth, i == 0);
    shapeless += evidence.verdict &&
        evidence.verdict[p] == static_cast<std::uint8_t>(RegimeVerdict::PointForceSuffices)
      ? 1
      : 0;
    if (evidence.validity && depth > static_cast<double>(evidence.validity[p]))
    {
      ++beyond;
      ++limits[evidence.limit ? std::min<std::size_t>(evidence.limit[p], ResponseLimitCount - 1)
                              : 0];
    }
  }
  const auto all = static_cast<double>(curves.count());
  choice.regimeKnown = evidence.verdict != nullptr;
  choice.shapelessShare = static_cast<double>(shapeless) / all;
  choice.validityKnown = evidence.validity != nullptr;
  choice.beyondShare = static_cast<double>(beyond) / all;
  choice.firstLimit =
    static_cast<int>(std::max_element(limits.begin(), limits.end()) - limits.begin());
}

/// Returns the slope of the secant from 0 to the end of the range, N/mm.
double secant(const ReducibleCurves& curves, std::size_t i, const Eigen::VectorXd& curve)
{
  return curve[curves.sampling().samples() - 1] / curves.range(i);
}

/// Returns the largest |k δ - F| for δ up to the range, divided by F at the range, where k is the
/// secant; infinite if a value is not finite.
double lossOf(const ReducibleCurves& curves, std::size_t i)
{
  const Eigen::VectorXd curve = curves.curve(i);
  const SampledCurve right{ curve, curves.sampling() };
  const double range = curves.range(i);
  const double k = secant(curves, i, curve);
  const int steps = 4 * curves.sampling().samples();
  double loss = 0.0;
  for (int step = 1; step < steps; ++step)
  {
    const double s = static_cast<double>(step) / steps;
    const double depth = range * s * s;
    const double off = std::abs(k * depth - right.evaluate(range, depth).force) / (k * range);
    if (!std::isfinite(off))
    {
      return std::numeric_limits<double>::infinity();
    }
    loss = std::max(loss, off);
  }
  return loss;
}

/// Errors and stiffnesses of the springs at a range of points.
struct SpringsFound
{
  std::size_t kept = 0;
  double loss = 0.0;
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;

  SpringsFound& operator+=(const SpringsFound& other)
  {
    this->kept += other.kept;
    this->loss = std::max(this->loss, other.loss);
    this->least = std::min(this->least, other.least);
    this->most = std::max(this->most, other.most);
    return *this;
  }
};

/// Stores F = k δ. If all points have the same range, F is k times one law. Otherwise F is a sum of
/// two laws, whose coefficients are the force at the range (k times range) and k.
void storeSprings(
  ResponseChoice& choice, const ResponseArrays& arrays, const ReducibleCurves& curves)
{
  const ResponseSampling sampling(arrays.samples, 1.0);
  const bool oneRange = choice.range.least == choice.range.most;
  const auto n = static_cast<std::size_t>(arrays.samples);
  const std::size_t laws = oneRange ? 1 : 2;
  choice.laws = static_cast<int>(laws);
  choice.basis.assign(laws * 2 * n, 0.0F);
  for (std::size_t k = 0; k < n; ++k)
  {
    const double unit = oneRange ? choice.range.most : 1.0;
    choice.basis[k] = static_cast<float>(sampling.depth(static_cast<int>(k), unit));
    choice.basis[(2 * laws - 1) * n + k] = 1.0F;
  }
  choice.coefficient.assign(laws * arrays.points, 0.0F);
  for (std::size_t i = 0; i < curves.count(); ++i)
  {
    float* row = choice.coefficient.data() + laws * curves.point(i);
    const double k = secant(curves, i, curves.curve(i));
    row[0] = static_cast<float>(oneRange ? k : k * curves.range(i));
    row[laws - 1] = static_cast<float>(k);
  }
  choice.exponent = 1.0;
}

/// Chooses one spring per point if the evidence allows a point force, and if the error of the
/// springs is within the tolerance at the fraction `share` of the points. Stores the errors and
/// stiffnesses of the springs in either case.
bool chooseSprings(ResponseChoice& choice, const ResponseArrays& arrays,
  const ReducibleCurves& curves, const ChoiceSettings& settings)
{
  if (!choice.regimeKnown || choice.shapelessShare < settings.share ||
    (choice.validityKnown && choice.beyondShare > 1.0 - settings.share))
  {
    return false;
  }
  const SpringsFound found = curves.sum(SpringsFound{},
    [&](SpringsFound& sum, std::size_t i)
    {
      const double loss = lossOf(curves, i);
      const double k = secant(curves, i, curves.curve(i));
      sum += { loss <= settings.tolerance ? std::size_t(1) : std::size_t(0), loss, k, k };
    });
  const double share = static_cast<double>(found.kept) / static_cast<double>(curves.count());
  choice.springTried = true;
  choice.springLoss = found.loss;
  choice.spring = { found.least, found.most };
  if (share < settings.share)
  {
    return false;
  }
  choice.need = ResponseNeed::PointForce;
  choice.keptShare = share;
  choice.largestError = found.loss;
  storeSprings(choice, arrays, curves);
  choice.numbersPerPoint = choice.laws;
  return true;
}
} // namespace

ResponseChoice chooseResponse(
  const ResponseArrays& arrays, const ChoiceEvidence& evidence, const ChoiceSettings& settings)
{
  ResponseChoice choice;
  choice.exponent = arrays.exponent;
  choice.numbersPerPoint = arrays.basis ? arrays.laws : 2 * arrays.samples;
  const ReducibleCurves curves(arrays);
  choice.points = curves.count();
  if (curves.count() == 0)
  {
    return choice;
  }
  lookAtPoints(choice, curves, evidence, settings);
  if (!chooseSprings(choice, arrays, curves, settings))
  {
    chooseLaws(choice, arrays, curves, settings);
  }
  return choice;
}
} // namespace palpate
