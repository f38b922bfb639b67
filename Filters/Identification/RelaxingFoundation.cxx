// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/RelaxingFoundation.h"

#include "Mechanics/Relaxation/QuasiLinearElement.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using Eigen::Index;
constexpr std::size_t BlockSize = RelaxationElements::LargestCount;
} // namespace

/// A curve, given by the increments of the slopes of its chords, one increment for each element.
struct RelaxingFoundation::Prepared
{
  std::vector<RelaxationElements::Values> weights;
};

RelaxingFoundation::RelaxingFoundation(double depth, std::size_t blocks)
  : Depths(static_cast<Index>(blocks * BlockSize + 1))
  , Gaps(blocks)
{
  const auto count = static_cast<double>(blocks * BlockSize);
  for (Index j = 0; j < this->Depths.size(); ++j)
  {
    const double share = static_cast<double>(j) / count;
    this->Depths[j] = depth * share * share;
  }
  for (std::size_t j = 0; j < blocks * BlockSize; ++j)
  {
    this->Gaps[j / BlockSize].add(this->Depths[static_cast<Index>(j)]);
  }
}

RelaxingFoundation::Prepared RelaxingFoundation::prepare(const SlowCurve& curve) const
{
  Prepared prepared;
  prepared.weights.resize(this->Gaps.size());
  double before = 0.0;
  for (Index j = 0; j + 1 < this->Depths.size(); ++j)
  {
    const double slope =
      (curve.force[j + 1] - curve.force[j]) / (this->Depths[j + 1] - this->Depths[j]);
    const auto element = static_cast<std::size_t>(j);
    prepared.weights[element / BlockSize][element % BlockSize] = slope - before;
    before = slope;
  }
  return prepared;
}

/// Returns the difference between the curve (cubic interpolation with slopes) and its chords.
double RelaxingFoundation::remainder(const SlowCurve& curve, double depth) const
{
  const Index last = this->Depths.size() - 1;
  if (!(depth > 0.0) || depth >= this->Depths[last])
  {
    return 0.0;
  }
  // Rounding errors may change the index j by one.
  auto j = static_cast<Index>(static_cast<double>(last) * std::sqrt(depth / this->Depths[last]));
  j = std::clamp<Index>(j, 0, last - 1);
  const double width = this->Depths[j + 1] - this->Depths[j];
  const double t = std::clamp((depth - this->Depths[j]) / width, 0.0, 1.0);
  const double slope = (curve.force[j + 1] - curve.force[j]) / width;
  return width * t * (1.0 - t) *
    ((1.0 - t) * (curve.stiffness[j] - slope) - t * (curve.stiffness[j + 1] - slope));
}

Eigen::MatrixXd RelaxingFoundation::follow(const PressHistory& history, double offset,
  const PronySeries& series, const std::vector<SlowCurve>& curves) const
{
  const std::size_t blocks = this->Gaps.size();
  std::vector<Prepared> prepared;
  prepared.reserve(curves.size());
  for (const SlowCurve& curve : curves)
  {
    prepared.push_back(this->prepare(curve));
  }
  std::vector<RelaxationElements> elements(blocks);
  std::vector<QuasiLinearElement> remainders(curves.size());
  std::vector<double> left(curves.size(), 0.0);
  Eigen::MatrixXd forces(static_cast<Index>(history.size()), static_cast<Index>(curves.size()));
  RelaxationStep step(series, 0.0);
  double lasts = 0.0; // duration of `step`, s
  double before = 0.0;
  // If the history begins in contact, the press began before the first reading.
  if (history.size() > 1 && history.deflection[0] > offset)
  {
    const double way = history.deflection[1] - history.deflection[0];
    before = way > 0.0
      ? (history.deflection[0] - offset) * (history.time[1] - history.time[0]) / way
      : 0.0;
  }
  for (std::size_t i = 0; i < history.size(); ++i)
  {
    const double seconds = i > 0 ? history.time[i] - history.time[i - 1] : before;
    if (seconds != lasts)
    {
      step = RelaxationStep(series, seconds);
      lasts = seconds;
    }
    const double depth = history.deflection[i] - offset;
    for (std::size_t b = 0; b < blocks; ++b)
    {
      elements[b].relax(step);
      elements[b].press(depth, this->Gaps[b], step);
    }
    for (std::size_t c = 0; c < curves.size(); ++c)
    {
      double sum = 0.0;
      for (std::size_t b = 0; b < blocks && elements[b].awake() > 0; ++b)
      {
        sum += elements[b].forceOf(prepared[c].weights[b]);
      }
      if (curves[c].stiffness.size() > 0)
      {
        const double now = this->remainder(curves[c], depth);
        const double memory = remainders[c].follow(now - left[c], step);
        left[c] = now;
        sum = elements[0].isTouched() ? std::max(0.0, sum + now + memory) : 0.0;
      }
      forces(static_cast<Index>(i), static_cast<Index>(c)) = sum;
    }
  }
  return forces;
}
} // namespace palpate
