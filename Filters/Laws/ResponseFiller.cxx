// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/ResponseFiller.h"

#include "Contact/ParallelRanges.h"
#include "Laws/BodyMaterial.h"
#include "Laws/ResponseLaw.h"
#include "Laws/TrustedDepth.h"
#include "Mechanics/SeriesCompliance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr auto Valid = static_cast<unsigned char>(ResponseStatus::Valid);
// Largest number of blocks. The caller can stop the computation after each block.
constexpr std::size_t MostBlocks = 20;
// Number of points of a block per thread. A block takes about 50 ms, so that a caller who stops the
// computation waits at most this long, and the cost of starting threads is small.
constexpr std::size_t PointsPerThread = 16384;
// Depth of first contact, as a fraction of the first sample's depth.
constexpr double FirstContactDepth = 1e-3;

/// Returns whether the contact at a spot is that of a flat half-space, except for the factor of the
/// modulus.
bool isBare(const ContactSpot& spot)
{
  return spot.thickness == 0.0 && spot.compliance == 0.0 && spot.curvature.isFlat();
}
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

void ResponseFiller::estimate(const LocalContact& contact, const LawScope& scope, double tolerance,
  const MeasuredBodyError* measured)
{
  this->Contact = &contact;
  this->Measured = measured;
  this->Errors = std::make_unique<ErrorRule>(this->Tool, scope);
  this->Tolerance = tolerance;
  this->ErrorDepths = { FirstContactDepth * this->Law.depths().front() };
  this->ErrorDepths.insert(
    this->ErrorDepths.end(), this->Law.depths().begin(), this->Law.depths().end());
  this->FlatStates.clear();
  if (!contact.corrects({}))
  {
    this->FlatStates.resize(this->ErrorDepths.size());
    contact.states({}, this->ErrorDepths, this->FlatStates.data());
  }
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
  float* force = this->Spans.force + n * i;
  float* stiffness = this->Spans.stiffness + n * i;
  unsigned char& status = this->Spans.status[i];
  const bool isAnswered = status == Valid && bound >= 0.0 && this->Contact->answers(spot);
  if (!isAnswered)
  {
    status = this->fillCurve(i, spot, bound);
  }
  else if (!this->FlatStates.empty() && isBare(spot))
  {
    status = static_cast<unsigned char>(this->Law.sample(spot, force, stiffness));
    if (status == Valid)
    {
      return this->estimated(
        i, [this](std::size_t k) { return this->FlatStates[k]; }, true, spot, surface);
    }
  }
  else if (this->Contact->isDirect(spot))
  {
    static thread_local std::vector<LocalState> states; // reused for all points of one thread
    states.resize(n + 1);
    const bool fits = this->Contact->states(spot, this->ErrorDepths, states.data());
    status = static_cast<unsigned char>(this->Contact->corrects(spot)
        ? this->Law.sample(states.data() + 1, spot, force, stiffness)
        : this->Law.sample(spot, force, stiffness));
    if (status == Valid)
    {
      const LocalState* found = states.data();
      return this->estimated(
        i, [found](std::size_t k) { return found[k]; }, fits, spot, surface);
    }
  }
  else
  {
    bool fits = true;
    const NodeLaw local = this->Contact->law(spot, fits);
    status = static_cast<unsigned char>(this->Contact->corrects(spot)
        ? this->Law.sample(local, spot, force, stiffness)
        : this->Law.sample(spot, force, stiffness));
    if (status == Valid)
    {
      const auto stateAt = [&](std::size_t k)
      {
        const double depth = this->ErrorDepths[k];
        return local.at(spot.compliance == 0.0
            ? depth
            : seriesResponse(local, spot.reducedModulus, spot.compliance, depth).localDeflection);
      };
      return this->estimated(i, stateAt, fits, spot, surface);
    }
  }
  if (this->Spans.error)
  {
    std::fill_n(this->Spans.error + n * i, n, std::numeric_limits<float>::quiet_NaN());
  }
  return { 0.0, status == Valid ? ResponseLimit::Thickness : ResponseLimit::None };
}

template <class StateAt>
ValidityRule::Answer ResponseFiller::estimated(std::size_t i, const StateAt& stateAt, bool fits,
  const ContactSpot& spot, const SpotSurface& surface) const
{
  const auto n = static_cast<std::size_t>(this->Spans.samples);
  ResponseLimit limit = ResponseLimit::None;
  TrustedDepth trusted(static_cast<double>(this->Range), n, this->Tolerance);
  const StrainCorrection::Course strain = this->Errors->strain(spot);
  static thread_local std::vector<double> thickness; // reused for all points of a thread
  thickness.assign(n, 0.0);
  if (spot.hasThicknessError())
  {
    this->Law.thicknessEffect(spot, thickness.data());
  }
  for (std::size_t k = n + 1; k-- > 0;)
  {
    const LocalState state = stateAt(k);
    const std::size_t sample = k > 0 ? k - 1 : 0;
    ErrorParts parts = this->Errors->at(spot, surface, strain, state, thickness[sample]);
    if (!fits || !state.isCovered)
    {
      parts[ResponseLimit::Curvature] = 1.0;
    }
    if (this->Measured)
    {
      parts[ResponseLimit::DataEnd] = this->Measured->data(i, sample);
    }
    const double error = parts.total();
    if (k > 0 && this->Spans.error)
    {
      this->Spans.error[n * i + k - 1] = static_cast<float>(error);
    }
    const bool isTrusted = trusted.add(k, error);
    limit = isTrusted ? limit : parts.largest();
    if (isTrusted && !this->Spans.error)
    {
      break;
    }
  }
  return { trusted.depth(), limit };
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
  PreparedLaw prepared = prepareLaw(
    tool, range, spans.samples, bounds, terms.curvature || terms.strain || estimates, terms.strain);
  if (estimates && bounds.isUncertain())
  {
    prepared.law.prepareUncertain(bounds.preparedUncertain());
  }
  const ResponseLaw& law = prepared.law;
  const ContactSpots spots = material.spots();
  MadeResponse made;
  made.exponent = material.bestExponent(tool, law);
  ResponseFiller filler(tool, law, range, shape.width, spans);
  if (estimates)
  {
    filler.estimate(*prepared.contact,
      { terms.curvature, terms.strain, shape.width, material.storageError(law, made.exponent),
        bounds.hasStack() ? &bounds.stack : nullptr, terms.edges },
      terms.errorTolerance, terms.measured);
  }
  const bool isMeasured = estimates && terms.measured;
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
          const LocalState measured = isMeasured ? terms.measured->contact(i) : LocalState{};
          const SpotSurface surface{ terms.curvature || estimates ? shape.curvature(i)
                                                                  : SpotCurvature{},
            estimates && shape.edge ? shape.edge(i) : NearEdge{},
            measured.radius > 0.0 ? &measured : nullptr };
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
