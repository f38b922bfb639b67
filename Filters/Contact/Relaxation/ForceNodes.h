// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceNodes_h
#define palpate_ForceNodes_h

#include "Contact/ResponseField.h"
#include "Mechanics/Relaxation/RelaxationElements.h"

#include <array>
#include <cstddef>

namespace palpate
{
/**
 * Depths between which a curve is taken by its chords, for RelaxationElements: g_j = range (j/N)²,
 * j = 0..N, where samples of curves of that range lie. With N = 16 and the usual 8 samples every
 * other node is one, and those between are sums of two samples: a curve's chords take no root and
 * no power. Curves of another range are evaluated node by node.
 */
class PALPATE_EXPORT ForceNodes
{
public:
  using Values = RelaxationElements::Values;

  /// None.
  ForceNodes() = default;
  /// `elements` from 1; `range` in mm.
  ForceNodes(const ResponseSampling& sampling, double range, int elements) noexcept;

  /// N + 1.
  std::size_t count() const noexcept { return this->Count; }
  const Values& gaps() const noexcept { return this->Gaps; }

  /// The slopes of the first `count` chords, N/mm; the last of all is the tangent at the end.
  void slopes(const BlendedResponse& curve, std::size_t count, Values& slopes) const noexcept;
  /// Their steps, of which none is negative: the weights of the elements.
  static void steps(const Values& slopes, std::size_t count, Values& weights) noexcept
  {
    double before = 0.0;
    for (std::size_t j = 0; j < count; ++j)
    {
      const double step = slopes[j] - before;
      weights[j] = step > 0.0 ? step : 0.0;
      before = slopes[j];
    }
  }
  /// f_N, the slow force of elements of these weights.
  double slowForce(const Values& weights, double depth) const noexcept
  {
    double sum = 0.0;
    for (std::size_t j = 0; j < this->Count && depth > this->Gaps[j]; ++j)
    {
      sum += weights[j] * (depth - this->Gaps[j]);
    }
    return sum;
  }

private:
  /// F at a node, from the forces and stiffnesses of sample `lower` and the next.
  struct Node
  {
    int lower = 0;
    Eigen::Vector4d shares = Eigen::Vector4d::Zero();
  };

  std::size_t Count = 0;
  double Range = 0.0;
  Values Gaps{};
  std::array<double, RelaxationElements::LargestCount> InverseWidth{};
  std::array<Node, RelaxationElements::LargestCount> Nodes{};
};
} // namespace palpate

#endif
