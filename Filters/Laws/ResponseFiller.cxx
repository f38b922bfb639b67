// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/ResponseFiller.h"

#include "Contact/ParallelRanges.h"
#include "Laws/BodyMaterial.h"
#include "Laws/ResponseLaw.h"
#include "Mechanics/SeriesCompliance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr auto Valid = static_cast<unsigned char>(ResponseStatus::Valid);
constexpr std::size_t MostBlocks = 20;         // after each of which the caller is asked
constexpr std::size_t PointsPerThread = 65536; // in a block: threads cost less than that
constexpr double AtTouch = 1e-3;               // of the first sample's depth
} // namespace

ResponseFiller::ResponseFiller(const AxisymmetricTool& tool, const ResponseLaw& law, double range,
  double bodyWidth, const ResponseSpans& spans)
  : Tool(tool)
  , Law(law)
  , Spans(spans)
  , Range(static_cast<float>(range))
  , Rule(tool, law, static_cast<double>(this->Range), bodyWidth)
{
}

void ResponseFiller::estimate(const LocalContact& contact, const LawScope& scope, double tolerance)
{
  this->Contact = &contact;
  this->Errors = std::make_unique<ErrorRule>(this->Tool, scope);
  this->Tolerance = tolerance;
}

void ResponseFiller::fill(std::size_t i, const ContactSpot& spot, double curvature) const
{
  this->fill(i, spot, curvature, {});
}

void ResponseFiller::fill(
  std::size_t i, const ContactSpot& spot, double bound, const SpotSurface& surface) const
{
  this->Spans.range[i] = this->Range;
  ValidityRule::Answer trusted{ 0.0, ResponseLimit::None };
  if (this->Errors)
  {
    trusted = this->fillEstimated(i, spot, bound, surface);
  }
  else
  {
    this->Spans.status[i] = this->fillCurve(i, spot, bound);
    trusted = this->Spans.status[i] == Valid ? this->Rule.at(spot, bound) : trusted;
  }
  this->Spans.validity[i] = static_cast<float>(trusted.depth);
  this->Spans.limit[i] = static_cast<unsigned char>(trusted.limit);
}

ValidityRule::Answer ResponseFiller::fillEstimated(
  std::size_t i, const ContactSpot& spot, double bound, const SpotSurface& surface) const
{
  const auto n = static_cast<std::size_t>(this->Spans.samples);
  if (this->Spans.status[i] == Valid && bound >= 0.0 && this->Contact->answers(spot))
  {
    bool fits = true;
    const NodeLaw local = this->Contact->law(spot, fits);
    float* force = this->Spans.force + n * i;
    float* stiffness = this->Spans.stiffness + n * i;
    this->Spans.status[i] = static_cast<unsigned char>(this->Contact->corrects(spot)
        ? this->Law.sample(local, spot, force, stiffness)
        : this->Law.sample(spot, force, stiffness));
    if (this->Spans.status[i] == Valid)
    {
      return this->estimated(i, local, fits, spot, surface);
    }
  }
  else
  {
    this->Spans.status[i] = this->fillCurve(i, spot, bound);
  }
  if (this->Spans.error)
  {
    std::fill_n(this->Spans.error + n * i, n, std::numeric_limits<float>::quiet_NaN());
  }
  return { 0.0, ResponseLimit::None };
}

ErrorParts ResponseFiller::errorAt(
  const NodeLaw& local, const ContactSpot& spot, const SpotSurface& surface, double depth) const
{
  const double own = spot.compliance == 0.0
    ? depth
    : seriesResponse(local, spot.reducedModulus, spot.compliance, depth).localDeflection;
  return this->Errors->at(spot, surface, local.at(own));
}

/// Between the samples the error is straight over √δ, as strain is below a sphere.
ValidityRule::Answer ResponseFiller::estimated(std::size_t i, const NodeLaw& local, bool fits,
  const ContactSpot& spot, const SpotSurface& surface) const
{
  const int n = this->Spans.samples;
  const ResponseSampling sampling(n, 1.0);
  const double range = this->Range;
  ValidityRule::Answer trusted{ range, ResponseLimit::None };
  double before = 0.0;
  for (int k = 0; k <= n; ++k)
  {
    const double depth = k == 0 ? AtTouch * sampling.depth(0, range) : sampling.depth(k - 1, range);
    ErrorParts parts = this->errorAt(local, spot, surface, depth);
    if (!fits)
    {
      parts[ResponseLimit::Curvature] = 1.0;
    }
    const double error = parts.total();
    if (k > 0 && this->Spans.error)
    {
      this->Spans.error[static_cast<std::size_t>(n) * i + static_cast<std::size_t>(k - 1)] =
        static_cast<float>(error);
    }
    if (trusted.limit == ResponseLimit::None && !(error <= this->Tolerance))
    {
      const double fraction = k == 0 ? 0.0 : (this->Tolerance - before) / (error - before);
      const double root = k == 0 ? 0.0 : (k - 1 + (std::isfinite(fraction) ? fraction : 0.0)) / n;
      trusted = { range * root * root, parts.largest() };
      if (!this->Spans.error)
      {
        break;
      }
    }
    before = error;
  }
  return trusted;
}

unsigned char ResponseFiller::fillCurve(std::size_t i, const ContactSpot& spot, double bound) const
{
  const auto n = static_cast<std::size_t>(this->Spans.samples);
  float* force = this->Spans.force + n * i;
  float* stiffness = this->Spans.stiffness + n * i;
  if (this->Spans.status[i] != Valid || bound < 0.0)
  {
    std::fill_n(force, n, 0.0F);
    std::fill_n(stiffness, n, 0.0F);
    return this->Spans.status[i] != Valid ? this->Spans.status[i]
                                          : static_cast<unsigned char>(ResponseStatus::Degenerate);
  }
  return static_cast<unsigned char>(this->Law.sample(spot, force, stiffness));
}

MadeResponse response(const AxisymmetricTool& tool, const BodyMaterial& material, double range,
  std::size_t points, const SurfaceShape& shape, const ResponseTerms& terms,
  const ResponseSpans& spans, const std::function<bool(double)>& goOn)
{
  const MaterialRange& bounds = material.range();
  const bool estimates = terms.errorTolerance > 0.0;
  ResponseLaw law(tool, range, spans.samples);
  const LayerTable::Layers layers = bounds.hasLayers() ? bounds.prepared() : LayerTable::Layers();
  std::shared_ptr<const LocalContact> contact;
  if (terms.curvature || terms.strain || estimates)
  {
    auto made = std::make_shared<LocalContact>(tool, range, bounds.stiffens, terms.strain);
    if (bounds.hasLayers())
    {
      made->prepareLayers(layers);
    }
    contact = made;
    law.correct(contact);
  }
  if (bounds.hasLayers())
  {
    law.prepareLayers(layers, bounds.stiffens);
  }
  const ContactSpots spots = material.spots();
  MadeResponse made;
  made.exponent = material.bestExponent(tool, law);
  ResponseFiller filler(tool, law, range, shape.width, spans);
  if (estimates)
  {
    filler.estimate(*contact,
      { terms.curvature, terms.strain, shape.width, material.storageError(law, made.exponent),
        bounds.hasStack() ? &bounds.stack : nullptr },
      terms.errorTolerance);
  }
  const std::size_t blocks = rangeCount(points) == 1
    ? MostBlocks
    : std::clamp<std::size_t>(points / (PointsPerThread * threadCount()), 1, MostBlocks);
  for (std::size_t block = 0; block < blocks; ++block)
  {
    const std::size_t begin = points * block / blocks;
    forRanges(points * (block + 1) / blocks - begin,
      [&](std::size_t first, std::size_t last)
      {
        for (std::size_t i = begin + first; i < begin + last; ++i)
        {
          ContactSpot spot = spots.at(i);
          const SpotSurface surface{ terms.curvature || estimates ? shape.curvature(i)
                                                                  : SpotCurvature{},
            estimates && shape.edge ? shape.edge(i) : NearEdge{} };
          spot.curvature = terms.curvature ? surface.curvature : SpotCurvature{};
          filler.fill(i, spot, shape.bound(i), surface);
        }
      });
    if (goOn && !goOn(static_cast<double>(block + 1) / static_cast<double>(blocks)))
    {
      return made;
    }
  }
  made.complete = true;
  made.without =
    points - static_cast<std::size_t>(std::count(spans.status, spans.status + points, Valid));
  return made;
}
} // namespace palpate
