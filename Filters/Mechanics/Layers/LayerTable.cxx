// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Layers/LayerTable.h"

#include "Mechanics/Numerics/ChebyshevRule.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Layers/StackTable.h"
#include "Mechanics/RecentValues.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
/// Returns the thickness of the thinnest layer on which the law is valid down to `depth`, that is,
/// on which a(depth) <= LargestRatio h.
double thinnestAnswered(
  const AxisymmetricTool& tool, const std::shared_ptr<const LayerKernel>& kernel, double depth)
{
  const auto answered = [&](double thickness)
  { return LayerContact(tool, kernel, thickness).deepest() >= depth; };
  double above = tool.contactRadius(depth) / LayerKernel::LargestRatio;
  for (int i = 0; i < 60 && !answered(above); ++i)
  {
    above *= 1.5; // the contact radius on a layer is larger than on a half-space
  }
  double below = 0.0;
  for (int i = 0; i < 60 && above - below > 1e-9 * above; ++i)
  {
    const double middle = 0.5 * (below + above);
    (answered(middle) ? above : below) = middle;
  }
  return above;
}

/// The input of a table. Equal stacks share their kernels, so that the address of the kernels
/// identifies the stack.
struct CurvesKey
{
  std::string tool;
  LayerTable::Layers layers;
  std::vector<double> depths;

  bool operator==(const CurvesKey& other) const
  {
    return this->tool == other.tool && this->depths == other.depths &&
      this->layers.base == other.layers.base && this->layers.thinnest == other.layers.thinnest &&
      this->layers.thickest == other.layers.thickest &&
      this->layers.poissonRatios == other.layers.poissonRatios &&
      this->layers.stack == other.layers.stack;
  }
};
} // namespace

LayerTable::LayerTable(
  const AxisymmetricTool& tool, const Layers& layers, std::vector<double> depths)
  : LayerCurves(std::move(depths))
  , Scale(tool.contactRadius(this->Depths.back()))
  , Ratios(layers.poissonRatios)
  , FirstRatio(layers.poissonRatios.front())
  , LastRatio(layers.poissonRatios.back())
{
  if (this->Ratios.size() > DistinctRatios)
  {
    this->RatiosAreChebyshev = true;
    this->Ratios.resize(DistinctRatios);
    for (Eigen::Index i = 0; i < DistinctRatios; ++i)
    {
      this->Ratios[static_cast<std::size_t>(i)] = this->FirstRatio +
        0.5 * (1.0 + RatioRule::standard().points()[i]) * (this->LastRatio - this->FirstRatio);
    }
  }
  std::vector<std::shared_ptr<const LayerKernel>> kernels;
  this->Thinnest = layers.thinnest;
  for (const double ratio : this->Ratios)
  {
    kernels.push_back(LayerKernel::shared(ratio, layers.base));
    if (LayerContact(tool, kernels.back(), layers.thinnest).deepest() < this->Depths.back())
    {
      this->Thinnest =
        std::max(this->Thinnest, thinnestAnswered(tool, kernels.back(), this->Depths.back()));
    }
  }

  this->Begin = this->Scale / (this->Scale + std::max(layers.thickest, this->Thinnest));
  this->End = this->Scale / (this->Scale + this->Thinnest);
  const auto count = static_cast<Eigen::Index>(this->Depths.size());
  for (const auto& kernel : kernels)
  {
    Curves curves(3 * count, static_cast<Eigen::Index>(ThicknessPoints));
    for (int point = 0; point < ThicknessPoints; ++point)
    {
      const LayerContact contact(tool, kernel, this->thicknessAt(point));
      for (Eigen::Index i = 0; i < count; ++i)
      {
        const IndentationPoint at =
          contact.evaluate(this->Depths[static_cast<std::size_t>(i)], 1.0);
        curves(i, point) = at.force;
        curves(count + i, point) = at.stiffness;
        curves(2 * count + i, point) = at.contactRadius;
      }
    }
    this->Tables.push_back(std::move(curves));
  }
}

double LayerTable::thicknessAt(int point) const
{
  const double x = this->Begin +
    0.5 * (1.0 + ThicknessRule::standard().points()[point]) * (this->End - this->Begin);
  return this->Scale / x - this->Scale;
}

LayerTable::ThicknessRule::Values LayerTable::thicknessFactors(double thickness) const
{
  const double x = this->Scale / (this->Scale + thickness);
  const double width = this->End - this->Begin;
  return ThicknessRule::standard().factorsAt(
    width > 0.0 ? std::clamp(2.0 * (x - this->Begin) / width - 1.0, -1.0, 1.0) : 0.0);
}

Eigen::ArrayXd LayerTable::ratioFactors(double poissonRatio) const
{
  if (this->RatiosAreChebyshev)
  {
    const double width = this->LastRatio - this->FirstRatio;
    return RatioRule::standard().factorsAt(2.0 * (poissonRatio - this->FirstRatio) / width - 1.0);
  }
  Eigen::ArrayXd factors = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(this->Ratios.size()));
  const auto found = std::find(this->Ratios.begin(), this->Ratios.end(), poissonRatio);
  if (found == this->Ratios.end())
  {
    factors.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  else
  {
    factors[found - this->Ratios.begin()] = 1.0;
  }
  return factors;
}

LayerTable::Curve LayerTable::sample(double thickness, double poissonRatio) const
{
  Curve curve(static_cast<Eigen::Index>(this->Depths.size()), 3);
  if (!this->answers(thickness))
  {
    curve.setConstant(std::numeric_limits<double>::quiet_NaN());
    return curve;
  }
  const ThicknessRule::Values factors = this->thicknessFactors(thickness);
  const Eigen::ArrayXd ratios = this->ratioFactors(poissonRatio);
  curve.setZero();
  Eigen::Map<Eigen::VectorXd> all(curve.data(), curve.size());
  for (std::size_t k = 0; k < this->Tables.size(); ++k)
  {
    const double factor = ratios[static_cast<Eigen::Index>(k)];
    if (factor != 0.0)
    {
      all.noalias() += this->Tables[k] * (factor * factors).matrix();
    }
  }
  return curve;
}

std::shared_ptr<const LayerCurves> makeLayerCurves(
  const AxisymmetricTool& tool, const LayerTable::Layers& layers, const std::vector<double>& depths)
{
  constexpr std::size_t mostTables = 64;
  constexpr std::size_t mostBytes = std::size_t{ 64 } << 20;
  static RecentValues<CurvesKey, LayerCurves> recent(mostTables, mostBytes);
  return recent.get({ tool.specification(), layers, depths },
    [&]
    {
      std::shared_ptr<const LayerCurves> curves;
      std::size_t columns = 0;
      if (layers.stack)
      {
        curves = std::make_shared<const StackTable>(tool, layers.stack, depths);
        columns = layers.stack->nodes().size();
      }
      else
      {
        curves = std::make_shared<const LayerTable>(tool, layers, depths);
        columns = LayerTable::ThicknessPoints *
          std::min<std::size_t>(layers.poissonRatios.size(), LayerTable::DistinctRatios);
      }
      return std::pair(std::move(curves), 3 * sizeof(double) * depths.size() * columns);
    });
}
} // namespace palpate
