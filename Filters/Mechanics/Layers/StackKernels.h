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
/// The smallest and the largest thickness of a layer, mm; equal if the thickness is constant.
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
 * The kernels of a stack whose first two layers vary in thickness. The nodes are Chebyshev points
 * of ln h: 6 to 16 per layer, depending on the width of the thickness range, or one if the
 * thickness is constant.
 *
 * Smooth functions of the thicknesses are interpolated between the nodes. For stacks with ratios of
 * moduli of 1 to 50 and of thicknesses of 1 to 20, the forces agree to 1e-3 with those of a
 * separate kernel (StackTableTest.cxx). A kernel takes about 50 ms on all threads. The kernels do
 * not depend on the tool.
 */
class PALPATE_EXPORT StackKernels
{
public:
  /// `first` and `second` replace the thicknesses of the first two layers of `stack`, which must
  /// have no fault (LayerStack.h). `second` is ignored for a single layer.
  StackKernels(LayerStack stack, ThicknessSpan first, ThicknessSpan second);

  /// Returns kernels from a cache of the process, which holds up to 1000 kernels. Thread-safe.
  static std::shared_ptr<const StackKernels> shared(
    const LayerStack& stack, const ThicknessSpan& first, const ThicknessSpan& second);

  /// The kernel of a stack at one node.
  struct Node
  {
    double thickness; ///< thickness of the first layer, mm
    std::shared_ptr<const LayerKernel> kernel;
  };
  const std::vector<Node>& nodes() const noexcept { return this->Nodes; }

  /// Returns the weight of each node at the given thicknesses (mm, within the spans). The sum of
  /// the weights is 1.
  Eigen::VectorXd factorsAt(double first, double second) const;

  const LayerStack& stack() const noexcept { return this->Stack; }
  const ThicknessSpan& first() const noexcept { return this->Axes[0].Span; }
  const ThicknessSpan& second() const noexcept { return this->Axes[1].Span; }

private:
  using Rule = ChebyshevRule<Eigen::Dynamic>;
  /// The nodes over the thickness of one layer.
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
