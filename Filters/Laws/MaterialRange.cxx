// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/MaterialRange.h"

#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace palpate
{
namespace
{
void addRatio(double poissonRatio, std::vector<double>& ratios)
{
  if (!ratios.empty() && ratios.back() == poissonRatio)
  {
    return;
  }
  const auto place = std::lower_bound(ratios.begin(), ratios.end(), poissonRatio);
  const bool known = place != ratios.end() && *place == poissonRatio;
  if (!known && static_cast<int>(ratios.size()) <= LayerTable::DistinctRatios)
  {
    ratios.insert(place, poissonRatio);
  }
  else if (!known) // the list is full: only its smallest and largest values are updated
  {
    ratios.front() = std::min(ratios.front(), poissonRatio);
    ratios.back() = std::max(ratios.back(), poissonRatio);
  }
}

/// Includes the layers of one place in `layers` and `second`.
void include(const LayerPlace& place, LayerTable::Layers& layers, ThicknessSpan& second)
{
  if (place.thickness > 0.0)
  {
    layers.thinnest = std::min(layers.thinnest, place.thickness);
    layers.thickest = std::max(layers.thickest, place.thickness);
    addRatio(place.poissonRatio, layers.poissonRatios);
  }
  if (place.second > 0.0)
  {
    second.thinnest = std::min(second.thinnest, place.second);
    second.thickest = std::max(second.thickest, place.second);
  }
}

/// Includes another range of layers in `layers` and `second`.
void include(const LayerTable::Layers& other, const ThicknessSpan& otherSecond,
  LayerTable::Layers& layers, ThicknessSpan& second)
{
  layers.thinnest = std::min(layers.thinnest, other.thinnest);
  layers.thickest = std::max(layers.thickest, other.thickest);
  for (const double ratio : other.poissonRatios)
  {
    addRatio(ratio, layers.poissonRatios);
  }
  second.thinnest = std::min(second.thinnest, otherSecond.thinnest);
  second.thickest = std::max(second.thickest, otherSecond.thickest);
}

LayerTable::Layers withKernels(
  LayerTable::Layers layers, const LayerStack& stack, const ThicknessSpan& second)
{
  if (!stack.layers.empty())
  {
    layers.stack = StackKernels::shared(stack, { layers.thinnest, layers.thickest }, second);
  }
  return layers;
}
} // namespace

MaterialRange::MaterialRange(LayerBase base, LayerStack stackBelow)
  : layers{ base, Infinity, 0.0, {} }
  , stack(std::move(stackBelow))
  , second{ Infinity, 0.0 }
  , uncertain(layers)
  , uncertainSecond(second)
{
}

LayerTable::Layers MaterialRange::prepared() const
{
  return withKernels(this->layers, this->stack, this->second);
}

LayerTable::Layers MaterialRange::preparedUncertain() const
{
  return withKernels(this->uncertain, this->stack, this->uncertainSecond);
}

void MaterialRange::add(const ContactSpot& spot)
{
  include(spot.place(), this->layers, this->second);
  if (spot.hasThicknessError())
  {
    include(spot.thinnestPlace(), this->uncertain, this->uncertainSecond);
  }
  this->hasHalfSpace = this->hasHalfSpace || !(spot.thickness > 0.0);
  this->leastRatio = std::min(this->leastRatio, spot.poissonRatio);
  this->mostRatio = std::max(this->mostRatio, spot.poissonRatio);
  this->stiffens = this->stiffens || spot.compliance < 0.0;
  this->widen(spot);
}

void MaterialRange::join(const MaterialRange& other)
{
  include(other.layers, other.second, this->layers, this->second);
  include(other.uncertain, other.uncertainSecond, this->uncertain, this->uncertainSecond);
  this->hasHalfSpace = this->hasHalfSpace || other.hasHalfSpace;
  this->leastRatio = std::min(this->leastRatio, other.leastRatio);
  this->mostRatio = std::max(this->mostRatio, other.mostRatio);
  this->stiffens = this->stiffens || other.stiffens;
  if (this->extremes.empty())
  {
    this->extremes = other.extremes;
  }
  for (const ContactSpot& spot : other.extremes)
  {
    this->widen(spot);
  }
}

void MaterialRange::widen(const ContactSpot& spot)
{
  if (this->extremes.empty())
  {
    this->extremes.assign(4, spot);
  }
  const auto softness = [](const ContactSpot& at) { return at.reducedModulus * at.compliance; };
  const auto thinness = [](const ContactSpot& at) // thinness; 0 for a half-space
  {
    return (at.thickness > 0.0 ? 1.0 / at.thickness : 0.0) +
      (at.second > 0.0 ? 1.0 / at.second : 0.0);
  };
  std::vector<ContactSpot>& extreme = this->extremes;
  extreme[0] = softness(spot) < softness(extreme[0]) ? spot : extreme[0];
  extreme[1] = softness(spot) > softness(extreme[1]) ? spot : extreme[1];
  extreme[2] = thinness(spot) > thinness(extreme[2]) ? spot : extreme[2];
  extreme[3] = thinness(spot) < thinness(extreme[3]) ? spot : extreme[3];
}

StrainBodies MaterialRange::strainBodies() const
{
  StrainBodies bodies{ this->leastRatio, this->mostRatio, this->hasHalfSpace, 0.0, 0.0,
    this->layers.base, this->stack, this->second };
  if (this->hasLayers())
  {
    bodies.thinnest = this->layers.thinnest;
    bodies.thickest = this->layers.thickest;
  }
  return bodies;
}
} // namespace palpate
