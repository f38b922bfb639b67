// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Layers/LayerKernel.h"

#include "Mechanics/Layers/LayerStack.h"

#include "Mechanics/Numerics/ChebyshevRule.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Numerics/GaussLegendre.h"
#include "Mechanics/RecentValues.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr double LargestOmega = 20.0; // e^(-2ω) is below 1e-17 at the largest ω
constexpr int OmegaPanels = 20;
// Smallest ω for a stack, in which deep layers have an effect at small ω.
constexpr double LeastOmega = 1.0 / 4096;

// Ranges of a/h. In each range a polynomial of degree 15 through Chebyshev points approximates the
// solution with an error of 1e-10, even for a nearly incompressible layer.
constexpr std::array<double, 9> RatioEnds = { 0.0, 0.25, 0.6, 1.1, 1.8, 2.8, 4.3, 6.5,
  LayerKernel::LargestRatio };
constexpr int RatioPoints = 16;

struct Transform
{
  double normal; ///< W - 1
  double radial; ///< V - V(∞)
};

/// Both transforms decrease as e^(-2ω). The formulas use e = e^(-2ω), so that there is no overflow
/// and no cancellation.
Transform transformAt(double omega, double nu, LayerBase base)
{
  const double e = std::exp(-2.0 * omega);
  const double w2 = 4.0 * omega * omega;
  if (base == LayerBase::Slip)
  {
    const double d = -std::expm1(-4.0 * omega) + 4.0 * omega * e; // D multiplied by 2 e
    return { 2.0 * e * (std::expm1(-2.0 * omega) - 2.0 * omega) / d, -4.0 * omega * e / d };
  }
  const double k = 3.0 - 4.0 * nu;
  const double d = k * (1.0 + e * e) + (w2 + 1.0 + k * k) * e; // D multiplied by e
  const double step = 1.0 + 2.0 * omega;
  return { -e * (2.0 * k * e + step * step + k * k) / d,
    -e * ((1.0 - 2.0 * nu) * ((1.0 + k) * (1.0 + k) + w2) + w2) / (2.0 * (1.0 - nu) * d) };
}

/// The transforms at the nodes of a rule that resolves sin ωs for s up to 4 LargestRatio.
struct SampledTransform
{
  std::vector<double> omega;
  std::vector<double> normal;
  std::vector<double> radial;

  SampledTransform(double nu, LayerBase base)
  {
    this->addPanels([nu, base](double w) { return transformAt(w, nu, base); }, 0.0);
  }

  explicit SampledTransform(const LayerStack& stack)
  {
    const auto at = [&stack](double w)
    {
      const StackTransform found = stackTransform(stack, w);
      return Transform{ found.normal, found.radial };
    };
    this->addPanel(at, 0.0, LeastOmega);
    for (double end = LeastOmega; end < 1.0; end *= 2.0)
    {
      this->addPanel(at, end, 2.0 * end);
    }
    this->addPanels(at, 1.0);
  }

  template <class Function>
  void addPanels(const Function& at, double from)
  {
    const double width = LargestOmega / OmegaPanels;
    for (int panel = static_cast<int>(from / width); panel < OmegaPanels; ++panel)
    {
      this->addPanel(at, width * panel, width * (panel + 1));
    }
  }

  template <class Function>
  void addPanel(const Function& function, double from, double to)
  {
    static const GaussLegendre rule(32);
    for (Eigen::Index i = 0; i < rule.nodes().size(); ++i)
    {
      const double w = from + (to - from) * 0.5 * (1.0 + rule.nodes()[i]);
      const double weight = 0.5 * (to - from) * rule.weights()[i];
      const Transform at = function(w);
      this->omega.push_back(w);
      this->normal.push_back(weight * at.normal);
      this->radial.push_back(weight * at.radial);
    }
  }

  double cosine(double s) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->omega.size(); ++i)
    {
      sum += this->normal[i] * std::cos(this->omega[i] * s);
    }
    return sum;
  }

  double sine(double s) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->omega.size(); ++i)
    {
      sum += this->radial[i] * std::sin(this->omega[i] * s);
    }
    return sum;
  }
};

const GaussLegendre& rule()
{
  static const GaussLegendre standing(LayerKernel::NodeCount);
  return standing;
}

const ChebyshevRule<RatioPoints>& chebyshev()
{
  return ChebyshevRule<RatioPoints>::standard();
}
} // namespace

LayerKernel::LayerKernel(double poissonRatio, LayerBase base)
  : PoissonsRatio(poissonRatio)
  , Base(base)
{
  this->tabulate(SampledTransform(poissonRatio, base));
}

LayerKernel::LayerKernel(const LayerStack& stack)
  : PoissonsRatio(stack.layers.front().poissonRatio)
  , Base(stack.base)
  , Stack(std::make_shared<const LayerStack>(stack))
{
  this->tabulate(SampledTransform(stack));
}

std::shared_ptr<const LayerKernel> LayerKernel::shared(double poissonRatio, LayerBase base)
{
  constexpr std::size_t mostKernels = 64;
  static RecentValues<std::pair<double, LayerBase>, LayerKernel> recent(mostKernels, mostKernels);
  return recent.get({ poissonRatio, base },
    [&] {
      return std::pair(std::make_shared<const LayerKernel>(poissonRatio, base), std::size_t{ 1 });
    });
}

template <class SampledTransform>
void LayerKernel::tabulate(const SampledTransform& transform)
{
  // M and L are analytic within |Im s| < 2, so that the pieces have length 1. M and L decrease only
  // as 1/s² and 1/s, and LayerSurface needs them up to this end.
  const double end = 4.0 * LargestRatio;
  this->Normal = { end, static_cast<int>(end), [&](double s) { return transform.cosine(s); } };
  this->Radial = { end, static_cast<int>(end), [&](double s) { return transform.sine(s); } };

  for (std::size_t piece = 0; piece + 1 < RatioEnds.size(); ++piece)
  {
    Eigen::Matrix<double, 2 * NodeCount, Eigen::Dynamic> values(2 * NodeCount, RatioPoints);
    for (Eigen::Index i = 0; i < RatioPoints; ++i)
    {
      const double ratio = RatioEnds[piece] +
        0.5 * (1.0 + chebyshev().points()[i]) * (RatioEnds[piece + 1] - RatioEnds[piece]);
      const Solution solution = this->solve(ratio);
      values.col(i) << solution.flat.matrix(), solution.resolvent.matrix();
    }
    this->Table.push_back(std::move(values));
  }
}

LayerKernel::Matrix LayerKernel::scaledSystem(double ratio) const
{
  // After scaling by the square roots of the weights, I + K is symmetric. It is positive definite,
  // because the elastic energy is positive.
  const Samples x = ratio * nodes();
  const Samples root = weights().sqrt();
  Matrix system;
  for (int j = 0; j < NodeCount; ++j)
  {
    for (int i = j; i < NodeCount; ++i)
    {
      const double kernel = this->normal(x[i] + x[j]) + this->normal(x[i] - x[j]);
      system(i, j) = root[i] * root[j] * ratio / Pi * kernel + (i == j ? 1.0 : 0.0);
    }
  }
  return system;
}

LayerKernel::Solution LayerKernel::solve(double ratio) const
{
  const Samples root = weights().sqrt();
  Eigen::Matrix<double, NodeCount, 2> right;
  right.col(0) = root.matrix();
  for (int i = 0; i < NodeCount; ++i)
  {
    const double t = nodes()[i];
    right(i, 1) =
      root[i] * ratio / Pi * (this->normal(ratio * (1.0 + t)) + this->normal(ratio * (1.0 - t)));
  }
  const Eigen::Matrix<double, NodeCount, 2> found =
    this->scaledSystem(ratio).selfadjointView<Eigen::Lower>().llt().solve(right);
  return { found.col(0).array() / root, found.col(1).array() / root };
}

LayerKernel::Samples LayerKernel::solve(double ratio, const Samples& right) const
{
  const Samples root = weights().sqrt();
  const Eigen::Matrix<double, NodeCount, 1> scaled = (root * right).matrix();
  return this->scaledSystem(ratio).selfadjointView<Eigen::Lower>().llt().solve(scaled).array() /
    root;
}

LayerKernel::Solution LayerKernel::at(double ratio) const
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!(ratio >= 0.0 && ratio <= LargestRatio))
  {
    return { Samples::Constant(nan), Samples::Constant(nan) };
  }
  const auto end = std::lower_bound(RatioEnds.begin() + 1, RatioEnds.end() - 1, ratio);
  const auto piece = static_cast<std::size_t>(end - RatioEnds.begin()) - 1;
  const double t =
    2.0 * (ratio - RatioEnds[piece]) / (RatioEnds[piece + 1] - RatioEnds[piece]) - 1.0;

  const Eigen::Matrix<double, 2 * NodeCount, 1> both =
    this->Table[piece] * chebyshev().factorsAt(t).matrix();
  return { both.head<NodeCount>().array(), both.tail<NodeCount>().array() };
}

const LayerKernel::Samples& LayerKernel::nodes()
{
  static const Samples standing = 0.5 * (1.0 + rule().nodes());
  return standing;
}

const LayerKernel::Samples& LayerKernel::weights()
{
  static const Samples standing = 0.5 * rule().weights();
  return standing;
}

double LayerKernel::interpolate(const Samples& samples, double t)
{
  // Barycentric weights of Gauss-Legendre points: (-1)^i √((1-x²) w).
  static const Samples standing = []
  {
    Samples w = ((1.0 - rule().nodes().square()) * rule().weights()).sqrt();
    for (int i = 1; i < NodeCount; i += 2)
    {
      w[i] = -w[i];
    }
    return w;
  }();
  const Samples& x = nodes();
  double above = 0.0;
  double below = 0.0;
  for (int i = 0; i < NodeCount; ++i)
  {
    const double distance = t - x[i];
    if (distance == 0.0)
    {
      return samples[i];
    }
    const double factor = standing[i] / distance;
    above += factor * samples[i];
    below += factor;
  }
  return above / below;
}
} // namespace palpate
