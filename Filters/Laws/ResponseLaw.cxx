// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/ResponseLaw.h"

#include "Contact/ResponseSampling.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/SeriesCompliance.h"
#include "Laws/MaterialRange.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr int ErrorProbes = 200;
// The local part of a series has more samples than the stored curve. Therefore its storage error is
// (8/64)⁴ times that of the stored curve. With a negative compliance the local deflection exceeds
// the range.
constexpr int LocalSamples = 64;
constexpr double LocalDepths = 3.0;

/// Returns whether a float represents the number with full precision.
bool fitsFloat(double value)
{
  using Float = std::numeric_limits<float>;
  const double size = std::abs(value);
  return size == 0.0 ||
    (size >= static_cast<double>(Float::min()) && size <= static_cast<double>(Float::max()));
}

std::vector<double> depthsOf(const ResponseSampling& sampling, double range)
{
  std::vector<double> depths;
  depths.reserve(static_cast<std::size_t>(sampling.samples()));
  for (int i = 0; i < sampling.samples(); ++i)
  {
    depths.push_back(sampling.depth(i, range));
  }
  return depths;
}
} // namespace

/// A curve for E* = 1 as a law that can be combined in series with a compliance. It does not give a
/// contact radius.
class ResponseLaw::SampledLaw final : public IndentationLaw
{
public:
  SampledLaw(UnitCurve curve, const ResponseSampling& sampling, double range)
    : Curve(std::move(curve))
    , Sampling(sampling)
    , Range(range)
  {
  }

  IndentationPoint evaluate(double deflection, double reducedModulus) const override
  {
    const ResponseValue value = this->Sampling.evaluate(this->Curve, this->Range, deflection);
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return value.beyondRange
      ? IndentationPoint{ unknown, unknown, unknown }
      : IndentationPoint{ reducedModulus * value.force, reducedModulus * value.stiffness, unknown };
  }

private:
  UnitCurve Curve;
  const ResponseSampling& Sampling;
  double Range;
};

ResponseLaw::ResponseLaw(const AxisymmetricTool& tool, double range, int samples)
  : Tool(tool)
  , Range(range)
  , Samples(samples)
  , Depths(depthsOf(ResponseSampling(samples, 1.0), range))
  , LocalSampling(LocalSamples, tool.forceExponent())
  , LocalRange(range)
{
  for (const double depth : this->Depths)
  {
    const IndentationPoint at = tool.evaluate(depth, 1.0);
    this->HalfSpace.forces.push_back(at.force);
    this->HalfSpace.stiffnesses.push_back(at.stiffness);
  }
  this->HalfSpace.findExtremes();
}

void ResponseLaw::UnitCurve::findExtremes()
{
  this->least = Infinity;
  for (const std::vector<double>* values : { &this->forces, &this->stiffnesses })
  {
    for (const double value : *values)
    {
      this->least = value != 0.0 ? std::min(this->least, std::abs(value)) : this->least;
      this->most = std::max(this->most, std::abs(value));
    }
  }
  this->least = std::min(this->least, this->most);
}

void ResponseLaw::prepareLayers(const LayerTable::Layers& layers, bool stiffening)
{
  this->LocalRange = stiffening ? LocalDepths * this->Range : this->Range;
  this->Stored = makeLayerCurves(this->Tool, layers, this->Depths);
  this->Local =
    makeLayerCurves(this->Tool, layers, depthsOf(this->LocalSampling, this->LocalRange));
}

void ResponseLaw::prepareUncertain(const LayerTable::Layers& layers)
{
  this->Uncertain = makeLayerCurves(this->Tool, layers, this->Depths);
}

void ResponseLaw::thicknessEffect(const ContactSpot& spot, double* change) const
{
  const LayerPlace thinnest = spot.thinnestPlace();
  const bool isLayer = spot.thickness > 0.0;
  if (!this->Uncertain->answers(thinnest) || (isLayer && !this->Stored->answers(spot.place())))
  {
    std::fill_n(change, this->Samples, 1.0);
    return;
  }
  const LayerCurves::Curve stiff = this->Uncertain->sample(thinnest);
  const LayerCurves::Curve own =
    isLayer ? this->Stored->sample(spot.place()) : LayerCurves::Curve();
  for (int i = 0; i < this->Samples; ++i)
  {
    const double force = isLayer ? own(i, 0) : this->HalfSpace.force(i);
    change[i] = std::abs(stiff(i, 0) / force - 1.0);
  }
}

ResponseLaw::UnitCurve ResponseLaw::layerCurve(const LayerCurves& table, const ContactSpot& spot)
{
  const LayerCurves::Curve curve = table.sample(spot.place());
  const Eigen::Index n = curve.rows();
  UnitCurve unit{ { curve.data(), curve.data() + n }, { curve.data() + n, curve.data() + 2 * n } };
  unit.findExtremes();
  return unit;
}

ResponseStatus ResponseLaw::sample(const ContactSpot& spot, float* force, float* stiffness) const
{
  ResponseStatus status = ResponseStatus::Valid;
  if (this->isCorrected(spot) && this->Contact->isDirect(spot))
  {
    std::vector<LocalState> states(this->Depths.size());
    this->Contact->states(spot, this->Depths, states.data());
    return this->sample(states.data(), spot, force, stiffness);
  }
  if (this->isCorrected(spot))
  {
    status = this->Contact->answers(spot)
      ? this->solve(this->Contact->law(spot), spot, force, stiffness)
      : ResponseStatus::OutOfReach;
  }
  else if (spot.thickness > 0.0)
  {
    const LayerCurves& table = spot.compliance == 0.0 ? *this->Stored : *this->Local;
    status = !table.answers(spot.place()) ? ResponseStatus::OutOfReach
      : spot.compliance == 0.0
      ? this->scale(layerCurve(table, spot), spot.reducedModulus, force, stiffness)
      : this->solve(SampledLaw(layerCurve(table, spot), this->LocalSampling, this->LocalRange),
          spot, force, stiffness);
  }
  else
  {
    status = spot.compliance == 0.0
      ? this->scale(this->HalfSpace, spot.reducedModulus, force, stiffness)
      : this->solve(this->Tool, spot, force, stiffness);
  }
  return this->withZeros(status, force, stiffness);
}

ResponseStatus ResponseLaw::sample(
  const NodeLaw& local, const ContactSpot& spot, float* force, float* stiffness) const
{
  return this->withZeros(this->solve(local, spot, force, stiffness), force, stiffness);
}

ResponseStatus ResponseLaw::sample(
  const LocalState* states, const ContactSpot& spot, float* force, float* stiffness) const
{
  ResponseStatus status = ResponseStatus::Valid;
  for (int i = 0; i < this->Samples; ++i)
  {
    const double whole = spot.reducedModulus * states[i].force;
    const double local = spot.reducedModulus * states[i].stiffness;
    const double slope = local / (1.0 + spot.compliance * local);
    status = fitsFloat(whole) && fitsFloat(slope) ? status : ResponseStatus::NotFinite;
    force[i] = static_cast<float>(whole);
    stiffness[i] = static_cast<float>(slope);
  }
  return this->withZeros(status, force, stiffness);
}

/// Writes zeros if `status` is not Valid. Returns `status`.
ResponseStatus ResponseLaw::withZeros(ResponseStatus status, float* force, float* stiffness) const
{
  if (status != ResponseStatus::Valid)
  {
    std::fill_n(force, this->Samples, 0.0F);
    std::fill_n(stiffness, this->Samples, 0.0F);
  }
  return status;
}

ResponseStatus ResponseLaw::scale(
  const UnitCurve& curve, double reducedModulus, float* force, float* stiffness) const
{
  if (!fitsFloat(reducedModulus * curve.least) || !fitsFloat(reducedModulus * curve.most))
  {
    return ResponseStatus::NotFinite;
  }
  for (int i = 0; i < this->Samples; ++i)
  {
    force[i] = static_cast<float>(reducedModulus * curve.force(i));
    stiffness[i] = static_cast<float>(reducedModulus * curve.stiffness(i));
  }
  return ResponseStatus::Valid;
}

ResponseStatus ResponseLaw::solve(
  const IndentationLaw& local, const ContactSpot& spot, float* force, float* stiffness) const
{
  const ResponseSampling sampling(this->Samples, 1.0);
  for (int i = 0; i < this->Samples; ++i)
  {
    const SeriesPoint point =
      seriesResponse(local, spot.reducedModulus, spot.compliance, sampling.depth(i, this->Range));
    if (!point.stable)
    {
      return ResponseStatus::Folded;
    }
    if (!fitsFloat(point.force) || !fitsFloat(point.stiffness))
    {
      return ResponseStatus::NotFinite;
    }
    force[i] = static_cast<float>(point.force);
    stiffness[i] = static_cast<float>(point.stiffness);
  }
  return ResponseStatus::Valid;
}

IndentationPoint ResponseLaw::evaluate(const ContactSpot& spot, double deflection) const
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (this->isCorrected(spot))
  {
    const SeriesPoint point = this->Contact->answers(spot)
      ? seriesResponse(this->Contact->law(spot), spot.reducedModulus, spot.compliance, deflection)
      : SeriesPoint{ unknown, unknown, unknown, false };
    return { point.force, point.stiffness, unknown };
  }
  const bool layer = spot.thickness > 0.0;
  if (layer && !this->Local->answers(spot.place()))
  {
    return { unknown, unknown, unknown };
  }
  const SeriesPoint point = layer
    ? seriesResponse(
        SampledLaw(layerCurve(*this->Local, spot), this->LocalSampling, this->LocalRange),
        spot.reducedModulus, spot.compliance, deflection)
    : seriesResponse(this->Tool, spot.reducedModulus, spot.compliance, deflection);
  return { point.force, point.stiffness, unknown };
}

double ResponseLaw::deflectionAtContactRadius(const ContactSpot& spot, double a) const
{
  if (!(spot.thickness > 0.0))
  {
    return this->totalDeflection(spot, this->Tool.depthAtContactRadius(a));
  }
  // On a layer a is nearly linear in √δ. Therefore a is interpolated linearly in √δ between the
  // samples.
  const LayerCurves::Curve curve = this->Stored->sample(spot.place());
  double radius = this->Tool.smallestContactRadius();
  if (a <= radius)
  {
    return 0.0; // a flat end has this radius at any depth
  }
  double root = 0.0;
  for (int i = 0; i < this->Samples; ++i)
  {
    const double nextRadius = curve(i, 2);
    const double nextRoot = static_cast<double>(i + 1) / this->Samples;
    if (nextRadius > a)
    {
      root += std::max(0.0, a - radius) / (nextRadius - radius) * (nextRoot - root);
      return this->totalDeflection(spot, this->Range * root * root);
    }
    radius = nextRadius;
    root = nextRoot;
  }
  return Infinity;
}

double ResponseLaw::totalDeflection(const ContactSpot& spot, double localDepth) const
{
  if (spot.compliance == 0.0 || !std::isfinite(localDepth))
  {
    return localDepth;
  }
  const double force = spot.thickness > 0.0
    ? SampledLaw(layerCurve(*this->Local, spot), this->LocalSampling, this->LocalRange)
        .evaluate(localDepth, spot.reducedModulus)
        .force
    : this->Tool.force(localDepth, spot.reducedModulus);
  return localDepth + spot.compliance * force;
}

double ResponseLaw::storageError(double exponent, const ContactSpot& spot) const
{
  std::vector<float> forces(static_cast<std::size_t>(this->Samples));
  std::vector<float> stiffnesses(static_cast<std::size_t>(this->Samples));
  if (this->sample(spot, forces.data(), stiffnesses.data()) != ResponseStatus::Valid)
  {
    return Infinity;
  }
  const ResponseSampling sampling(this->Samples, exponent);
  const FloatCurve curve{ forces.data(), stiffnesses.data() };
  double largest = 0.0;
  for (int i = 2; i <= ErrorProbes; ++i)
  {
    const double depth = this->Range * i / ErrorProbes;
    const double exact = this->evaluate(spot, depth).force;
    const double stored = sampling.evaluate(curve, this->Range, depth).force;
    largest = std::max(largest, std::abs(stored / exact - 1.0));
  }
  return largest;
}

PreparedLaw prepareLaw(const AxisymmetricTool& tool, double range, int samples,
  const MaterialRange& bounds, bool hasContact, const StrainCorrection* strain)
{
  PreparedLaw made{ ResponseLaw(tool, range, samples), nullptr };
  const LayerTable::Layers layers = bounds.hasLayers() ? bounds.prepared() : LayerTable::Layers();
  if (hasContact)
  {
    auto contact = std::make_shared<LocalContact>(tool, range, bounds.stiffens, strain);
    if (bounds.hasLayers())
    {
      contact->prepareLayers(layers);
    }
    made.law.correct(contact);
    made.contact = std::move(contact);
  }
  if (bounds.hasLayers())
  {
    made.law.prepareLayers(layers, bounds.stiffens);
  }
  return made;
}
} // namespace palpate
