// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Layers/StackTable.h"

#include "Mechanics/Layers/LayerContact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr double ThicknessStep = 1.1;

bool isAnswered(const AxisymmetricTool& tool, const StackKernels& kernels, double depth)
{
  return std::all_of(kernels.nodes().begin(), kernels.nodes().end(),
    [&](const StackKernels::Node& node)
    { return LayerContact(tool, node.kernel, node.thickness).deepest() >= depth; });
}
} // namespace

StackTable::StackTable(const AxisymmetricTool& tool, std::shared_ptr<const StackKernels> kernels,
  std::vector<double> depths)
  : LayerCurves(std::move(depths))
  , Kernels(std::move(kernels))
{
  this->leaveOutTheThinnest(tool);
  if (!this->Kernels)
  {
    return;
  }
  const auto count = static_cast<Eigen::Index>(this->Depths.size());
  const auto& nodes = this->Kernels->nodes();
  this->Logarithms.resize(3 * count, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t node = 0; node < nodes.size(); ++node)
  {
    const LayerContact contact(tool, nodes[node].kernel, nodes[node].thickness);
    const auto column = static_cast<Eigen::Index>(node);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const IndentationPoint at = contact.evaluate(this->Depths[static_cast<std::size_t>(i)], 1.0);
      this->Logarithms(i, column) = std::log(at.force);
      this->Logarithms(count + i, column) = std::log(at.stiffness);
      this->Logarithms(2 * count + i, column) = std::log(at.contactRadius);
    }
  }
}

void StackTable::leaveOutTheThinnest(const AxisymmetricTool& tool)
{
  const double depth = this->Depths.back();
  if (isAnswered(tool, *this->Kernels, depth))
  {
    return;
  }
  const std::shared_ptr<const StackKernels> all = std::move(this->Kernels);
  const auto answersAt = [&](double thickness)
  {
    return isAnswered(
      tool, StackKernels(all->stack(), { thickness, thickness }, all->second()), depth);
  };
  double below = all->first().thinnest;
  double above = all->first().thickest;
  if (!answersAt(above))
  {
    return;
  }
  while (above > ThicknessStep * below)
  {
    const double middle = std::sqrt(below * above);
    (answersAt(middle) ? above : below) = middle;
  }
  auto rest = std::make_shared<const StackKernels>(
    all->stack(), ThicknessSpan{ above, all->first().thickest }, all->second());
  if (isAnswered(tool, *rest, depth))
  {
    this->Kernels = std::move(rest);
  }
}

bool StackTable::answers(const LayerPlace& place) const noexcept
{
  return this->Kernels && place.thickness >= this->Kernels->first().thinnest;
}

StackTable::Curve StackTable::sample(const LayerPlace& place) const
{
  Curve curve(static_cast<Eigen::Index>(this->Depths.size()), 3);
  if (!this->answers(place))
  {
    curve.setConstant(std::numeric_limits<double>::quiet_NaN());
    return curve;
  }
  Eigen::Map<Eigen::VectorXd> all(curve.data(), curve.size());
  all.noalias() = this->Logarithms * this->Kernels->factorsAt(place.thickness, place.second);
  all = all.array().exp();
  return curve;
}
} // namespace palpate
