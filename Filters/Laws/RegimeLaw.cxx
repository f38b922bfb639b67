// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/RegimeLaw.h"

#include "Mechanics/Tools/ToolSpecification.h"

#include <cmath>

namespace palpate
{
namespace
{
// Of the logarithm of the size: the central difference errs by step²/6, about 2e-5.
constexpr double SizeStep = 0.01;
constexpr int Samples = 8; // of laws that are never stored
} // namespace

RegimeLaw::RegimeLaw(const AxisymmetricTool& tool, const MaterialRange& range, double deepest)
  : Tool(tool)
  , Smaller(scaledTool(tool, std::exp(-SizeStep)))
  , Larger(scaledTool(tool, std::exp(SizeStep)))
{
  if (!this->Smaller || !this->Larger)
  {
    return;
  }
  this->Laws.emplace_back(tool, deepest, Samples);
  this->Laws.emplace_back(*this->Smaller, deepest, Samples);
  this->Laws.emplace_back(*this->Larger, deepest, Samples);
  if (range.hasLayers())
  {
    for (ResponseLaw& law : this->Laws)
    {
      law.prepareLayers(range.layers, range.stiffens);
    }
  }
}

double RegimeLaw::force(const ContactSpot& spot, double depth) const
{
  return this->Laws[0].evaluate(spot, depth).force;
}

double RegimeLaw::sensitivity(const ContactSpot& spot, double depth) const
{
  const double smaller = this->Laws[1].evaluate(spot, depth).force;
  const double larger = this->Laws[2].evaluate(spot, depth).force;
  return std::log(larger / smaller) / (2.0 * SizeStep);
}

SpotRegime RegimeLaw::regime(const ContactSpot& spot, double depth, double force) const
{
  SpotRegime found;
  found.index = regimeIndex(this->Tool, spot.reducedModulus, force, depth);
  found.sensitivity = this->sensitivity(spot, depth);
  found.verdict =
    std::isnan(found.index) ? RegimeVerdict::ShapeMatters : regimeVerdict(found.sensitivity);
  return found;
}
} // namespace palpate
