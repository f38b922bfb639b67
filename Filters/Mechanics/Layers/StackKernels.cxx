// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Layers/StackKernels.h"

#include "Mechanics/RecentValues.h"
#include "Mechanics/SharedWork.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace palpate
{
namespace
{
constexpr double PointsAtLeast = 5.0;
constexpr double PointsPerLog = 2.5; // additional points per factor of e in the thickness
constexpr double MostPoints = 16.0;

Eigen::Index pointCount(const ThicknessSpan& span)
{
  return span.thickest > span.thinnest
    ? static_cast<Eigen::Index>(std::min(MostPoints,
        std::ceil(PointsAtLeast + PointsPerLog * std::log(span.thickest / span.thinnest))))
    : 1;
}

/// The input from which kernels are computed.
struct StackKey
{
  LayerStack stack;
  ThicknessSpan first;
  ThicknessSpan second;

  bool operator==(const StackKey& other) const
  {
    return this->stack == other.stack && this->first == other.first && this->second == other.second;
  }
};
} // namespace

StackKernels::Axis::Axis(const ThicknessSpan& span)
  : Span(span)
  , Points(pointCount(span))
{
}

double StackKernels::Axis::thickness(Eigen::Index point) const
{
  return this->Points.points().size() == 1 ? this->Span.thinnest
                                           : this->Span.thinnest *
      std::pow(
        this->Span.thickest / this->Span.thinnest, 0.5 * (1.0 + this->Points.points()[point]));
}

StackKernels::Rule::Values StackKernels::Axis::factorsAt(double thickness) const
{
  if (this->Points.points().size() == 1)
  {
    return Rule::Values::Ones(1);
  }
  const double x = 2.0 * std::log(thickness / this->Span.thinnest) /
      std::log(this->Span.thickest / this->Span.thinnest) -
    1.0;
  return this->Points.factorsAt(std::clamp(x, -1.0, 1.0));
}

StackKernels::StackKernels(LayerStack stack, ThicknessSpan first, ThicknessSpan second)
  : Stack(std::move(stack))
  , Axes{ Axis(first), Axis(this->Stack.layers.size() > 1 ? second : ThicknessSpan{ 1.0, 1.0 }) }
{
  const Eigen::Index rows = this->Axes[0].Points.points().size();
  const Eigen::Index columns = this->Axes[1].Points.points().size();
  this->Nodes.resize(static_cast<std::size_t>(rows * columns));
  shareWork(this->Nodes.size(),
    [&](std::size_t i)
    {
      LayerStack own = this->Stack;
      const auto node = static_cast<Eigen::Index>(i);
      own.layers[0].thickness = this->Axes[0].thickness(node / columns);
      if (own.layers.size() > 1)
      {
        own.layers[1].thickness = this->Axes[1].thickness(node % columns);
      }
      this->Nodes[i] = { own.layers[0].thickness, std::make_shared<const LayerKernel>(own) };
    });
}

std::shared_ptr<const StackKernels> StackKernels::shared(
  const LayerStack& stack, const ThicknessSpan& first, const ThicknessSpan& second)
{
  constexpr std::size_t mostStacks = 16;
  constexpr std::size_t mostKernels = 1000; // a kernel needs 100 kB
  static RecentValues<StackKey, StackKernels> recent(mostStacks, mostKernels);
  return recent.get({ stack, first, second },
    [&]
    {
      auto kernels = std::make_shared<const StackKernels>(stack, first, second);
      const std::size_t count = kernels->nodes().size();
      return std::pair(std::move(kernels), count);
    });
}

Eigen::VectorXd StackKernels::factorsAt(double first, double second) const
{
  const Rule::Values rows = this->Axes[0].factorsAt(first);
  const Rule::Values columns = this->Axes[1].factorsAt(second);
  Eigen::VectorXd factors(rows.size() * columns.size());
  for (Eigen::Index i = 0; i < rows.size(); ++i)
  {
    factors.segment(i * columns.size(), columns.size()) = rows[i] * columns.matrix();
  }
  return factors;
}
} // namespace palpate
