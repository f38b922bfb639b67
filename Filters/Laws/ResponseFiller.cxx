// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/ResponseFiller.h"

#include "Contact/ParallelRanges.h"
#include "Laws/BodyMaterial.h"
#include "Laws/ResponseLaw.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr auto Valid = static_cast<unsigned char>(ResponseStatus::Valid);
constexpr std::size_t MostBlocks = 20;         // after each of which the caller is asked
constexpr std::size_t PointsPerThread = 65536; // in a block: threads cost less than that
} // namespace

ResponseFiller::ResponseFiller(const AxisymmetricTool& tool, const ResponseLaw& law, double range,
  double bodyWidth, const ResponseSpans& spans)
  : Law(law)
  , Spans(spans)
  , Range(static_cast<float>(range))
  , Rule(tool, law, static_cast<double>(this->Range), bodyWidth)
{
}

void ResponseFiller::fill(std::size_t i, const ContactSpot& spot, double curvature) const
{
  this->Spans.range[i] = this->Range;
  this->Spans.status[i] = this->fillCurve(i, spot, curvature);
  const ValidityRule::Answer trusted = this->Spans.status[i] == Valid
    ? this->Rule.at(spot, curvature)
    : ValidityRule::Answer{ 0.0, ResponseLimit::None };
  this->Spans.validity[i] = static_cast<float>(trusted.depth);
  this->Spans.limit[i] = static_cast<unsigned char>(trusted.limit);
}

/// Returns the status of the point.
unsigned char ResponseFiller::fillCurve(
  std::size_t i, const ContactSpot& spot, double curvature) const
{
  const auto n = static_cast<std::size_t>(this->Spans.samples);
  float* force = this->Spans.force + n * i;
  float* stiffness = this->Spans.stiffness + n * i;
  if (this->Spans.status[i] != Valid || curvature < 0.0)
  {
    std::fill_n(force, n, 0.0F);
    std::fill_n(stiffness, n, 0.0F);
    return this->Spans.status[i] != Valid ? this->Spans.status[i]
                                          : static_cast<unsigned char>(ResponseStatus::Degenerate);
  }
  return static_cast<unsigned char>(this->Law.sample(spot, force, stiffness));
}

MadeResponse response(const AxisymmetricTool& tool, const BodyMaterial& material, double range,
  double bodyWidth, std::size_t points, const std::function<double(std::size_t)>& curvature,
  const ResponseSpans& spans, const std::function<bool(double)>& goOn)
{
  ResponseLaw law(tool, range, spans.samples);
  if (material.range().hasLayers())
  {
    law.prepareLayers(material.range().layers, material.range().stiffens);
  }
  const ContactSpots spots = material.spots();
  const ResponseFiller filler(tool, law, range, bodyWidth, spans);
  const std::size_t blocks = rangeCount(points) == 1
    ? MostBlocks
    : std::clamp<std::size_t>(points / (PointsPerThread * threadCount()), 1, MostBlocks);
  MadeResponse made;
  for (std::size_t block = 0; block < blocks; ++block)
  {
    const std::size_t begin = points * block / blocks;
    forRanges(points * (block + 1) / blocks - begin,
      [&](std::size_t first, std::size_t last)
      {
        for (std::size_t i = begin + first; i < begin + last; ++i)
        {
          filler.fill(i, spots.at(i), curvature(i));
        }
      });
    if (goOn && !goOn(static_cast<double>(block + 1) / static_cast<double>(blocks)))
    {
      return made;
    }
  }
  made.complete = true;
  made.exponent = material.bestExponent(tool, law);
  made.without =
    points - static_cast<std::size_t>(std::count(spans.status, spans.status + points, Valid));
  return made;
}
} // namespace palpate
