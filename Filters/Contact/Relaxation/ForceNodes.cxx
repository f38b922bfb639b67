// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Relaxation/ForceNodes.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
ForceNodes::ForceNodes(const ResponseSampling& sampling, double range, int elements) noexcept
  : Count(std::min(static_cast<std::size_t>(elements) + 1, RelaxationElements::LargestCount))
  , Range(range)
  , InverseRange(1.0 / range)
{
  const double last = static_cast<double>(this->Count - 1);
  this->Gaps.add(0.0);
  for (std::size_t j = 1; j < this->Count; ++j)
  {
    const double share = static_cast<double>(j) / last;
    this->Gaps.add(range * (share * share));
    this->InverseWidth[j - 1] = 1.0 / (this->Gaps[j] - this->Gaps[j - 1]);
    const ResponseSampling::Place at = sampling.place(range, this->Gaps[j]);
    Node& node = this->Nodes[j];
    if (at.lower < 0)
    {
      // Below the first sample the curve is approximated by δ^m. The chords do not include the
      // difference.
      node.weights[0] = std::pow(this->Gaps[j] / sampling.depth(0, range), sampling.exponent());
      continue;
    }
    node.lower = at.lower;
    node.weights = { sampling.between({ 1.0, 0.0, 0.0, 0.0 }, at).force,
      sampling.between({ 0.0, 1.0, 0.0, 0.0 }, at).force,
      sampling.between({ 0.0, 0.0, 1.0, 0.0 }, at).force,
      sampling.between({ 0.0, 0.0, 0.0, 1.0 }, at).force };
  }
}

void ForceNodes::chordsOf(
  const BlendedResponse& curve, std::size_t count, Chords& chords) const noexcept
{
  const bool isSampled = curve.hasRange(this->Range);
  const std::size_t last = this->Count - 1;
  double before = 0.0; // force of the curve at the preceding node
  double begin = 0.0;  // force at the start of the chord
  double slope = 0.0;
  int lower = -1;
  Eigen::Vector4d samples = Eigen::Vector4d::Zero();
  for (std::size_t j = 0; j < count; ++j)
  {
    double steep = 0.0;
    if (j == last)
    {
      steep = curve.evaluate(this->Range).stiffness;
    }
    else
    {
      const Node& node = this->Nodes[j + 1];
      if (isSampled && node.lower != lower)
      {
        lower = node.lower;
        samples = curve.samples(lower);
      }
      const double force =
        isSampled ? node.weights.dot(samples) : curve.evaluate(this->Gaps[j + 1]).force;
      steep = (force - before) * this->InverseWidth[j];
      before = force;
    }
    const double step = std::max(steep - slope, 0.0);
    slope += step;
    chords.force[j] = begin;
    chords.slope[j] = slope;
    chords.weight[j] = step;
    begin += j < last ? slope * (this->Gaps[j + 1] - this->Gaps[j]) : 0.0;
  }
}
} // namespace palpate
