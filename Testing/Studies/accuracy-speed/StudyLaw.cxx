// SPDX-License-Identifier: BSD-3-Clause
#include "StudyLaw.h"

#include "Mechanics/Layers/LayerTable.h"
#include "Contact/ResponseSampling.h"
#include "Mechanics/SeriesCompliance.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

namespace palpate::testing
{
namespace
{
/// A law given as a function of the deflection, for one modulus.
class GivenLaw final : public IndentationLaw
{
public:
  explicit GivenLaw(std::function<IndentationPoint(double)> law)
    : Law(std::move(law))
  {
  }
  IndentationPoint evaluate(double deflection, double /*reducedModulus*/) const override
  {
    return this->Law(deflection);
  }

private:
  std::function<IndentationPoint(double)> Law;
};

/// One curve of SampledCurves, in the form that ResponseSampling reads.
struct OneCurve
{
  const SampledCurves& curves;
  std::size_t first;
  double force(int i) const { return curves.force[first + static_cast<std::size_t>(i)]; }
  double stiffness(int i) const { return curves.stiffness[first + static_cast<std::size_t>(i)]; }
};
} // namespace

StudyTool studyTool(const std::string& name, double range)
{
  ToolSpecification specification;
  std::string error;
  if (!parseTool(name, specification, error))
  {
    throw std::runtime_error(error);
  }
  return { name, range, makeTool(specification) };
}

StudyLaw::StudyLaw(StudyTool tool, StudyMaterial material)
  : Tool(std::move(tool))
  , Material(material)
{
}

IndentationPoint StudyLaw::local(double inverseThickness, double deflection) const
{
  if (!(inverseThickness > 0.0))
  {
    return this->Tool.shape->evaluate(deflection, this->Material.reducedModulus);
  }
  if (!this->Kernel)
  {
    this->Kernel = std::make_shared<LayerKernel>(this->Material.poissonRatio, LayerBase::Bonded);
  }
  if (!this->Layer || this->Inverse != inverseThickness)
  {
    this->Inverse = inverseThickness;
    this->Layer =
      std::make_unique<LayerContact>(*this->Tool.shape, this->Kernel, 1.0 / inverseThickness);
  }
  return this->Layer->evaluate(deflection, this->Material.reducedModulus);
}

IndentationPoint StudyLaw::evaluate(const Spot& spot, double deflection) const
{
  if (spot.compliance == 0.0)
  {
    return this->local(spot.inverseThickness, deflection);
  }
  const GivenLaw law([&](double depth) { return this->local(spot.inverseThickness, depth); });
  const SeriesPoint point =
    seriesResponse(law, this->Material.reducedModulus, spot.compliance, deflection);
  return { point.force, point.stiffness, std::numeric_limits<double>::quiet_NaN() };
}

SampledCurves StudyLaw::sample(const std::vector<Spot>& spots, int samples) const
{
  SampledCurves curves;
  curves.samples = samples;
  curves.range = this->Tool.range;
  curves.exponent = this->Tool.shape->forceExponent();
  const auto n = static_cast<std::size_t>(samples);
  curves.force.resize(n * spots.size());
  curves.stiffness.resize(n * spots.size());
  const bool isVariedLayer = std::any_of(spots.begin(), spots.end(),
    [&](const Spot& spot) { return spot.inverseThickness != spots.front().inverseThickness; });
  if (isVariedLayer)
  {
    this->sampleLayers(spots, curves);
  }
  else
  {
    const ResponseSampling sampling(samples, 1.0);
    for (std::size_t p = 0; p < spots.size(); ++p)
    {
      if (p > 0 && spots[p] == spots[p - 1])
      {
        std::copy_n(curves.force.begin() + static_cast<std::ptrdiff_t>((p - 1) * n), n,
          curves.force.begin() + static_cast<std::ptrdiff_t>(p * n));
        std::copy_n(curves.stiffness.begin() + static_cast<std::ptrdiff_t>((p - 1) * n), n,
          curves.stiffness.begin() + static_cast<std::ptrdiff_t>(p * n));
        continue;
      }
      for (std::size_t i = 0; i < n; ++i)
      {
        const IndentationPoint at =
          this->evaluate(spots[p], sampling.depth(static_cast<int>(i), curves.range));
        curves.force[p * n + i] = at.force;
        curves.stiffness[p * n + i] = at.stiffness;
      }
    }
  }
  const std::size_t middle = spots.size() / 2;
  SampledCurves straight = curves;
  straight.exponent = 1.0;
  if (this->storageError(straight, middle, spots[middle]) <
    this->storageError(curves, middle, spots[middle]))
  {
    curves.exponent = 1.0;
  }
  return curves;
}

/// Samples a different thickness at each point from the kernel's table; a microsecond per point.
void StudyLaw::sampleLayers(const std::vector<Spot>& spots, SampledCurves& curves) const
{
  const ResponseSampling sampling(curves.samples, 1.0);
  std::vector<double> depths;
  for (int i = 0; i < curves.samples; ++i)
  {
    depths.push_back(sampling.depth(i, curves.range));
  }
  double thickest = 0.0;
  double thinnest = std::numeric_limits<double>::infinity();
  const auto thicknessOf = [](const Spot& spot)
  {
    return spot.inverseThickness > 0.0 ? 1.0 / spot.inverseThickness
                                       : std::numeric_limits<double>::infinity();
  };
  for (const Spot& spot : spots)
  {
    thickest = std::max(thickest, thicknessOf(spot));
    thinnest = std::min(thinnest, thicknessOf(spot));
  }
  const LayerTable table(*this->Tool.shape,
    { LayerBase::Bonded, thinnest, thickest, { this->Material.poissonRatio } }, depths);
  const auto n = static_cast<std::size_t>(curves.samples);
  for (std::size_t p = 0; p < spots.size(); ++p)
  {
    const LayerTable::Curve curve =
      table.sample(thicknessOf(spots[p]), this->Material.poissonRatio);
    for (std::size_t i = 0; i < n; ++i)
    {
      const auto row = static_cast<Eigen::Index>(i);
      curves.force[p * n + i] = this->Material.reducedModulus * curve(row, 0);
      curves.stiffness[p * n + i] = this->Material.reducedModulus * curve(row, 1);
    }
  }
}

/// Largest relative error at 64 depths, from 1 % of the range on.
double StudyLaw::storageError(
  const SampledCurves& curves, std::size_t point, const Spot& spot) const
{
  const ResponseSampling sampling(curves.samples, curves.exponent);
  const OneCurve curve{ curves, point * static_cast<std::size_t>(curves.samples) };
  double worst = 0.0;
  for (int i = 0; i < 64; ++i)
  {
    const double depth = curves.range * (0.01 + 0.99 * i / 63.0);
    const double right = this->evaluate(spot, depth).force;
    const double found = sampling.evaluate(curve, curves.range, depth).force;
    worst = std::max(worst, std::abs(found / right - 1.0));
  }
  return worst;
}
} // namespace palpate::testing
