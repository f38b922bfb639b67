// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/RegimeLaw.h"

#include "Contact/ParallelRanges.h"
#include "Laws/BodyMaterial.h"
#include "Laws/LocalContact.h"
#include "Mechanics/SeriesCompliance.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
// Step of the logarithm of the tool's size. The error of the central difference is step²/6, about
// 2e-5.
constexpr double SizeStep = 0.01;
constexpr int Samples = 8; // number of samples of laws that are not stored with the response
constexpr double ResponseAgreement = 0.02;

/// Computes the forces of a response whose law includes the body's curvature.
std::vector<double> curvedForces(const AxisymmetricTool& tool, const BodyMaterial& material,
  const ComparedResponse& stored, const std::vector<double>& depths)
{
  const MaterialRange& bounds = material.range();
  const float* ranges = stored.arrays.range;
  const double deepest =
    depths.empty() ? 1.0 : static_cast<double>(*std::max_element(ranges, ranges + depths.size()));
  LocalContact contact(tool, deepest, bounds.stiffens, nullptr);
  if (bounds.hasLayers())
  {
    contact.prepareLayers(bounds.prepared());
  }
  const ContactSpots spots = material.spots();
  std::vector<double> forces(depths.size());
  forRanges(depths.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        ContactSpot spot = spots.at(i);
        spot.curvature = stored.curvature(i);
        if (contact.isDirect(spot))
        {
          // Solves the contact down to the range, because the result at the range decides whether
          // the tool fits.
          const std::vector<double> both = { depths[i],
            std::max(depths[i], static_cast<double>(ranges[i])) };
          std::array<LocalState, 2> states;
          contact.states(spot, both, states.data());
          forces[i] = spot.reducedModulus * states[0].force;
        }
        else if (contact.answers(spot))
        {
          forces[i] =
            seriesResponse(contact.law(spot), spot.reducedModulus, spot.compliance, depths[i])
              .force;
        }
      }
    });
  return forces;
}

/// Searches for a point at which the stored response does not match `forces` at `depths`. Returns a
/// message if there is one, or "" if all points match.
std::string compare(const ComparedResponse& given, const std::vector<double>& depths,
  const std::vector<double>& forces)
{
  const ResponseField stored(given.arrays);
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    const auto point = static_cast<std::int32_t>(i);
    const double range = given.arrays.range[i];
    if (!stored.isValid(point) || depths[i] < 0.01 * range || depths[i] > range)
    {
      continue;
    }
    const double force = stored.evaluate(point, depths[i]).force;
    const double allowed = std::max(ResponseAgreement, given.error ? given.error(i) : 0.0);
    if (std::abs(force - forces[i]) > allowed * forces[i])
    {
      return "Response '" + given.name + "' is of another material: point " + std::to_string(i) +
        " at " + std::to_string(depths[i]) + " mm gives " + std::to_string(force) +
        " N, but the given material " + std::to_string(forces[i]) + " N";
    }
  }
  return {};
}
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
    const LayerTable::Layers layers = range.prepared();
    for (ResponseLaw& law : this->Laws)
    {
      law.prepareLayers(layers, range.stiffens);
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

std::string regime(const AxisymmetricTool& tool, const BodyMaterial& material,
  const std::vector<double>& depths, double deepest, const ComparedResponse* stored,
  const RegimeSpans& spans)
{
  const RegimeLaw law(tool, material.range(), deepest);
  if (!law.complete())
  {
    return "Tool '" + tool.specification() + "' cannot be scaled";
  }
  const ContactSpots spots = material.spots();
  std::vector<double> forces(depths.size());
  forRanges(depths.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        forces[i] = law.force(spots.at(i), depths[i]);
      }
    });
  std::string fault = !stored
    ? std::string()
    : compare(*stored, depths,
        stored->curvature ? curvedForces(tool, material, *stored, depths) : forces);
  if (!fault.empty())
  {
    return fault;
  }
  forRanges(depths.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const SpotRegime found = law.regime(spots.at(i), depths[i], forces[i]);
        spans.index[i] = static_cast<float>(found.index);
        spans.sensitivity[i] = static_cast<float>(found.sensitivity);
        spans.verdict[i] = static_cast<std::uint8_t>(found.verdict);
      }
    });
  return {};
}
} // namespace palpate
