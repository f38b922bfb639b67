// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceNodes_h
#define palpate_ForceNodes_h

#include "Contact/ResponseField.h"
#include "Mechanics/Relaxation/RelaxationElements.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
/**
 * Depths between which a curve is replaced by its chords, for RelaxationElements: g_j = range
 * (j/N)², j = 0..N. A curve with this range has its samples at such depths. With N = 16 and the
 * usual 8 samples, every second node is a sample, and the force at a node in between is a weighted
 * sum of two samples. The chords of such a curve therefore need no square root and no power. Curves
 * with another range are evaluated node by node.
 */
class PALPATE_EXPORT ForceNodes
{
public:
  using Values = RelaxationElements::Values;

  /// Creates an object without nodes.
  ForceNodes() = default;
  /// `elements` must be at least 1. `range` is in mm.
  ForceNodes(const ResponseSampling& sampling, double range, int elements) noexcept;

  /// Number of nodes, N + 1.
  std::size_t count() const noexcept { return this->Count; }
  const RelaxationElements::Gaps& gaps() const noexcept { return this->Gaps; }

  /// The chords of a curve, which define f_N. Each chord begins at a node with a force (N) and has
  /// a slope (N/mm). The slopes do not decrease from chord to chord. Their increments are the
  /// weights of the elements.
  struct Chords
  {
    Values force{};
    Values slope{};
    Values weight{};
  };

  /// Computes the first `count` chords. The last chord of the complete set is the tangent at the
  /// end of the range.
  void chordsOf(const BlendedResponse& curve, std::size_t count, Chords& chords) const noexcept;
  /// Returns the index of the chord at a depth > 0.
  std::size_t chordAt(double depth) const noexcept
  {
    const std::size_t last = this->Count - 1;
    const double place = std::sqrt(depth * this->InverseRange) * static_cast<double>(last);
    const std::size_t chord =
      place < static_cast<double>(last) ? static_cast<std::size_t>(place) : last;
    // At the depth of a node, the chord that ends at the node is returned.
    return depth > this->Gaps[chord] ? chord : chord - 1;
  }
  /// Returns f_N, N; 0 for a depth of 0 or less.
  double slowForce(const Chords& chords, double depth) const noexcept
  {
    if (!(depth > 0.0))
    {
      return 0.0;
    }
    const std::size_t j = this->chordAt(depth);
    return chords.force[j] + chords.slope[j] * (depth - this->Gaps[j]);
  }

private:
  /// Weights with which the forces and stiffnesses of sample `lower` and of the next sample give F
  /// at a node.
  struct Node
  {
    int lower = 0;
    Eigen::Vector4d weights = Eigen::Vector4d::Zero();
  };

  std::size_t Count = 0;
  double Range = 0.0;
  double InverseRange = 0.0;
  RelaxationElements::Gaps Gaps;
  Values InverseWidth{};
  std::array<Node, RelaxationElements::LargestCount> Nodes{};
};
} // namespace palpate

#endif
