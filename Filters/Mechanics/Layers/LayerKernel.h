// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LayerKernel_h
#define palpate_LayerKernel_h

#include "Mechanics/PalpateExport.h"
#include "Mechanics/Numerics/ChebyshevRule.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace palpate
{
struct LayerStack;

/// The boundary condition between a layer and its rigid base.
enum class LayerBase
{
  Bonded, ///< no displacement at the base
  Slip    ///< no normal displacement and no friction at the base
};

/**
 * Contact on an elastic layer on a rigid base, for one Poisson's ratio and any tool.
 *
 * Under an axisymmetric pressure p the surface displacement of a layer of thickness h is (Hankel
 * transforms, ω = kh, κ₀ = 3-4ν)
 *   û_z = 2 W(ω) p̂ / (k E*),   û_r = -2 V(ω) p̂ / (k E*),
 *   bonded  W = (2κ₀ sinh 2ω - 4ω)/D,  V = [2κ₀(1-2ν)(cosh 2ω - 1) - 4ω²]/(2(1-ν) D),
 *           D = 2κ₀ cosh 2ω + 4ω² + 1 + κ₀²,
 *   slip    W = (cosh 2ω - 1)/D,       V = [(1-2ν) sinh 2ω - 2ω]/(2(1-ν) D),
 *           D = sinh 2ω + 2ω.
 * With π p̂ = E* ∫_0^a y(t) cos kt dt, the contact of a tool of reduced profile g is described by
 * the integral equation (Lebedev and Ufliand 1958)
 *   y(x) + (1/πh) ∫_0^a y(t) [M((t+x)/h) + M((t-x)/h)] dt = δ - g(x),  y(a) = 0 under a smooth rim,
 *   M(s) = ∫_0^∞ (W-1) cos ωs dω,   F = 2E* ∫_0^a y dt.
 *
 * The equation is solved by Nyström's method at 48 Gauss nodes for two right-hand sides. The
 * solutions depend only on a/h. They are tabulated when the kernel is created, which takes about 20
 * ms. Limits: 0 <= ν <= 0.5, a/h <= LargestRatio. The table agrees with the direct solution to
 * 1e-10. For a stack of layers W and V differ, but the equation is the same. Immutable; can be used
 * from any number of threads.
 */
class PALPATE_EXPORT LayerKernel
{
public:
  static constexpr int NodeCount = 48;
  static constexpr double LargestRatio = 10.0;
  using Samples = Eigen::Array<double, NodeCount, 1>;

  /// Smooth functions of t = x/a at the nodes of the rule on [0, 1].
  struct Solution
  {
    Samples flat;      ///< y for δ - g = 1: a flat punch pressed to the depth 1
    Samples resolvent; ///< Γ(1, t): y(a) = f(a) - ∫_0^1 Γ(1, t) f(t) dt for δ - g = f
  };

  LayerKernel(double poissonRatio, LayerBase base);
  /// Returns the kernel of a layer from a cache of the last 64 kernels of the process. Thread-safe.
  static std::shared_ptr<const LayerKernel> shared(double poissonRatio, LayerBase base);
  /// Creates the kernel of a stack that has no fault (LayerStack.h); h, ν and E* are those of the
  /// top layer. Takes about 50 ms.
  explicit LayerKernel(const LayerStack& stack);

  double poissonRatio() const noexcept { return this->PoissonsRatio; }
  LayerBase base() const noexcept { return this->Base; }
  /// The stack of this kernel; null for a single layer.
  const LayerStack* stack() const noexcept { return this->Stack.get(); }

  /// Returns M(s) for 0 <= s <= 4 LargestRatio.
  double normal(double s) const noexcept { return this->Normal.evaluate(s); }
  /// Returns L(s) = ∫_0^∞ (V - V(∞)) sin ωs dω. L is used for the radial displacement in the same
  /// way as M for the normal displacement.
  double radial(double s) const noexcept { return this->Radial.evaluate(s); }

  /// Returns the solution for a/h = ratio, 0 <= ratio <= LargestRatio, from the table.
  Solution at(double ratio) const;
  /// Returns the solution for a/h = ratio, solved directly.
  Solution solve(double ratio) const;
  /// Solves u(x) + ∫_0^1 K(x, t) u(t) dt = right(x) with K(x, t) = (a/πh) [M((x+t) a/h) + M((x-t)
  /// a/h)] for a/h = ratio. Returns u at the nodes.
  Samples solve(double ratio, const Samples& right) const;

  /// Nodes and weights of the rule on [0, 1].
  static const Samples& nodes();
  static const Samples& weights();
  /// Returns the value at 0 <= t <= 1 of the polynomial through samples at the nodes.
  static double interpolate(const Samples& samples, double t);

private:
  template <class SampledTransform>
  void tabulate(const SampledTransform& transform);

  using Matrix = Eigen::Matrix<double, NodeCount, NodeCount>;
  Matrix scaledSystem(double ratio) const;

  double PoissonsRatio;
  LayerBase Base;
  std::shared_ptr<const LayerStack> Stack;
  PiecewiseChebyshev Normal;
  PiecewiseChebyshev Radial;
  /// One matrix per range of a/h.
  std::vector<Eigen::Matrix<double, 2 * NodeCount, Eigen::Dynamic>> Table;
};
} // namespace palpate

#endif
