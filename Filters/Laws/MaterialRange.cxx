// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/MaterialRange.h"

#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace palpate
{
MaterialRange::MaterialRange(LayerBase base, LayerStack stackBelow)
  : layers{ base, Infinity, 0.0, {} }
  , stack(std::move(stackBelow))
  , second{ Infinity, 0.0 }
{
}

LayerTable::Layers MaterialRange::prepared() const
{
  LayerTable::Layers made = this->layers;
  if (this->hasStack())
  {
    made.stack = StackKernels::shared(this->stack, { made.thinnest, made.thickest }, this->second);
  }
  return made;
}

void MaterialRange::add(const ContactSpot& spot)
{
  if (spot.thickness > 0.0)
  {
    this->layers.thinnest = std::min(this->layers.thinnest, spot.thickness);
    this->layers.thickest = std::max(this->layers.thickest, spot.thickness);
    this->addRatio(spot.poissonRatio);
  }
  if (spot.second > 0.0)
  {
    this->second.thinnest = std::min(this->second.thinnest, spot.second);
    this->second.thickest = std::max(this->second.thickest, spot.second);
  }
  this->hasHalfSpace = this->hasHalfSpace || !(spot.thickness > 0.0);
  this->leastRatio = std::min(this->leastRatio, spot.poissonRatio);
  this->mostRatio = std::max(this->mostRatio, spot.poissonRatio);
  this->stiffens = this->stiffens || spot.compliance < 0.0;
  this->widen(spot);
}

void MaterialRange::join(const MaterialRange& other)
{
  this->layers.thinnest = std::min(this->layers.thinnest, other.layers.thinnest);
  this->layers.thickest = std::max(this->layers.thickest, other.layers.thickest);
  for (const double ratio : other.layers.poissonRatios)
  {
    this->addRatio(ratio);
  }
  this->second.thinnest = std::min(this->second.thinnest, other.second.thinnest);
  this->second.thickest = std::max(this->second.thickest, other.second.thickest);
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

void MaterialRange::addRatio(double poissonRatio)
{
  std::vector<double>& ratios = this->layers.poissonRatios;
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
  else if (!known) // the list is full: only the range is stored
  {
    ratios.front() = std::min(ratios.front(), poissonRatio);
    ratios.back() = std::max(ratios.back(), poissonRatio);
  }
}

void MaterialRange::widen(const ContactSpot& spot)
{
  if (this->extremes.empty())
  {
    this->extremes.assign(4, spot);
  }
  const auto softness = [](const ContactSpot& at) { return at.reducedModulus * at.compliance; };
  const auto thinness = [](const ContactSpot& at) // 0 for a half-space
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
