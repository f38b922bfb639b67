// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StackKernels_h
#define palpate_StackKernels_h

#include "Mechanics/Layers/LayerKernel.h"
#include "Mechanics/Layers/LayerStack.h"
#include "Mechanics/Numerics/ChebyshevRule.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

namespace palpate
{
/// The thinnest and the thickest that a layer is, mm; equal if it is constant.
struct ThicknessSpan
{
  double thinnest;
  double thickest;

  bool operator==(const ThicknessSpan& other) const
  {
    return this->thinnest == other.thinnest && this->thickest == other.thickest;
  }
};

/**
 * The kernels of a stack whose first two layers vary in thickness: at Chebyshev points of ln h, 6
 * to 16 of them by the width of the span, one where it has none.
 *
 * Smooth functions of the thicknesses are interpolated between them: forces of stacks with moduli
 * of 1 to 50 to 1 and thicknesses of 1 to 20 agree to 1e-3 with a kernel of their own
 * (StackTableTest.cxx). About 50 ms a kernel, on all threads. Serves any tool.
 */
class PALPATE_EXPORT StackKernels
{
public:
  /// `stack` without fault (LayerStack.h); the thicknesses of its first two layers come from the
  /// spans. `second` is ignored for a single layer.
  StackKernels(LayerStack stack, ThicknessSpan first, ThicknessSpan second);

  /// The same; the last ones are kept in the process, up to 1000 kernels. Thread-safe.
  static std::shared_ptr<const StackKernels> shared(
    const LayerStack& stack, const ThicknessSpan& first, const ThicknessSpan& second);

  /// A stack at one node.
  struct Node
  {
    double thickness; ///< of the first layer, mm
    std::shared_ptr<const LayerKernel> kernel;
  };
  const std::vector<Node>& nodes() const noexcept { return this->Nodes; }

  /// The weight of each node at these thicknesses (mm, within the spans); the weights sum to 1.
  Eigen::VectorXd factorsAt(double first, double second) const;

  const LayerStack& stack() const noexcept { return this->Stack; }
  const ThicknessSpan& first() const noexcept { return this->Axes[0].Span; }
  const ThicknessSpan& second() const noexcept { return this->Axes[1].Span; }

private:
  using Rule = ChebyshevRule<Eigen::Dynamic>;
  /// The points of one thickness.
  struct Axis
  {
    explicit Axis(const ThicknessSpan& span);
    double thickness(Eigen::Index point) const;
    Rule::Values factorsAt(double thickness) const;

    ThicknessSpan Span;
    Rule Points;
  };

  LayerStack Stack;
  std::array<Axis, 2> Axes;
  std::vector<Node> Nodes; ///< grouped by the thickness of the first layer
};
} // namespace palpate

#endif
