// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Curves/ShapedResponse.h"

#include "Contact/ResponseField.h"
#include "Contact/ResponseSampling.h"
#include "Solids/Curves/CurvesOnEdges.h"
#include "Laws/TrustedDepth.h"
#include "Mechanics/SharedWork.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Solids/TrueShape/ContactKernelFit.h"
#include "Solids/TrueShape/ShapedContact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace palpate
{
namespace
{
constexpr auto ValidPoint = static_cast<unsigned char>(ResponseStatus::Valid);
// The exponent is 1 for all tools, because the shape of the body may stiffen or soften the law of
// any tool.
constexpr double Exponent = 1.0;
constexpr double TiltErrorFactor = 0.2;
constexpr double LeastRange = 1e-3; // fraction of the requested range; shorter curves are discarded
// Depth of the additional sample, as a fraction of the first sample's depth.
constexpr double FirstSampleFraction = 1e-3;

using KernelsAt = std::function<std::unique_ptr<ContactKernels>(std::size_t)>;

/// Computes the points one by one. All threads share one object.
class ShapedFiller
{
public:
  ShapedFiller(const AxisymmetricTool& tool, const KernelsAt& kernelsAt, const ShapedTerms& terms,
    const ResponseSpans& spans)
    : Contact(tool, terms.strain)
    , At(kernelsAt)
    , Terms(terms)
    , Spans(spans)
    , Sampling(spans.samples, Exponent)
  {
  }

  void fill(std::size_t i) const
  {
    const auto n = static_cast<std::size_t>(this->Spans.samples);
    float* force = this->Spans.force + n * i;
    float* stiffness = this->Spans.stiffness + n * i;
    std::fill_n(force, n, 0.0F);
    std::fill_n(stiffness, n, 0.0F);
    if (this->Spans.error)
    {
      std::fill_n(this->Spans.error + n * i, n, std::numeric_limits<float>::quiet_NaN());
    }
    this->Spans.range[i] = static_cast<float>(this->Terms.range);
    this->Spans.validity[i] = 0.0F;
    if (this->Terms.surfaceError)
    {
      this->Terms.surfaceError[i] = std::numeric_limits<float>::quiet_NaN();
    }
    this->Spans.limit[i] = static_cast<unsigned char>(ResponseLimit::None);
    unsigned char& status = this->Spans.status[i];
    if (status != ValidPoint)
    {
      return;
    }
    const std::unique_ptr<ContactKernels> kernels = this->At(i);
    status = static_cast<unsigned char>(kernels->site().status);
    if (status != ValidPoint)
    {
      return;
    }
    const ContactCurve curve = this->Contact.curve(*kernels);
    // This depth is slightly less than the end of the curve, so that the last sample is still on
    // the curve after rounding to float.
    const double deepest = curve.isEmpty() ? 0.0 : (1.0 - 1e-6) * curve.deepest();
    if (!(deepest > LeastRange * this->Terms.range))
    {
      status = static_cast<unsigned char>(ResponseStatus::Edge);
      return;
    }
    const auto range = static_cast<float>(std::min(this->Terms.range, deepest));
    this->Spans.range[i] = range;
    for (std::size_t k = 0; k < n; ++k)
    {
      const IndentationPoint point =
        curve.evaluate(this->Sampling.depth(static_cast<int>(k), static_cast<double>(range)));
      force[k] = static_cast<float>(point.force);
      stiffness[k] = static_cast<float>(point.stiffness);
    }
    if (this->Terms.surfaceError)
    {
      this->Terms.surfaceError[i] =
        static_cast<float>(curve.errorsAt(static_cast<double>(range)).surface);
    }
    this->findValidity(i, curve);
  }

private:
  /// Computes the error and the validity of a point whose curve is stored.
  void findValidity(std::size_t i, const ContactCurve& curve) const
  {
    const auto n = static_cast<std::size_t>(this->Spans.samples);
    const auto range = static_cast<double>(this->Spans.range[i]);
    if (!(this->Terms.errorTolerance > 0.0))
    {
      this->Spans.validity[i] = this->Spans.range[i];
      return;
    }
    ResponseLimit limit = ResponseLimit::None;
    TrustedDepth trusted(range, n, this->Terms.errorTolerance);
    for (std::size_t k = n + 1; k-- > 0;)
    {
      const double depth = k > 0 ? this->Sampling.depth(static_cast<int>(k) - 1, range)
                                 : FirstSampleFraction * this->Sampling.depth(0, range);
      const IndentationPoint point = curve.evaluate(depth);
      const ContactSample errors = curve.errorsAt(depth);
      ErrorParts parts;
      parts[ResponseLimit::Strain] = errors.strain;
      parts[ResponseLimit::Curvature] = std::hypot(errors.gap, errors.direction);
      parts[ResponseLimit::Edge] =
        TiltErrorFactor * std::abs(errors.harmonics) * point.stiffness * depth / point.force;
      parts[ResponseLimit::Elements] = errors.elements();
      parts[ResponseLimit::None] = k > 0 ? this->storageError(i, k - 1, curve) : 0.0;
      double error = parts.norm(); // each part is a bound that holds in 95 of 100 cases
      error = std::isfinite(error) ? error : 1.0;
      if (k > 0 && this->Spans.error)
      {
        this->Spans.error[n * i + k - 1] = static_cast<float>(error);
      }
      limit = trusted.add(k, error) ? limit : parts.largest();
    }
    this->Spans.validity[i] = static_cast<float>(trusted.depth());
    this->Spans.limit[i] = static_cast<unsigned char>(limit);
  }

  /// Returns the relative error of the stored curve halfway to a sample.
  double storageError(std::size_t i, std::size_t k, const ContactCurve& curve) const
  {
    const auto n = static_cast<std::size_t>(this->Spans.samples);
    const auto range = static_cast<double>(this->Spans.range[i]);
    const double root = (static_cast<double>(k) + 0.5) / static_cast<double>(n);
    const double depth = range * root * root;
    const FloatCurve samples{ this->Spans.force + n * i, this->Spans.stiffness + n * i };
    const double stored = this->Sampling.evaluate(samples, range, depth).force;
    return std::abs(stored / curve.evaluate(depth).force - 1.0);
  }

  ShapedContact Contact;
  const KernelsAt& At;
  ShapedTerms Terms;
  ResponseSpans Spans;
  ResponseSampling Sampling;
};

/// Fills all points except those on edges. The result is incomplete if `goOn` stopped the work.
MadeResponse fillAll(const AxisymmetricTool& tool, std::size_t points, const KernelsAt& kernelsAt,
  const ShapedTerms& terms, const ResponseSpans& spans, const std::function<bool(double)>& goOn)
{
  const ShapedFiller filler(tool, kernelsAt, terms, spans);
  MadeResponse made;
  made.exponent = Exponent;
  made.complete = shareWork(
    points, [&filler](std::size_t i) { filler.fill(i); }, goOn);
  return made;
}

std::size_t countWithout(std::size_t points, const ResponseSpans& spans)
{
  ResponseArrays filled;
  filled.range = spans.range;
  filled.status = spans.status;
  std::size_t without = 0;
  for (std::size_t i = 0; i < points; ++i)
  {
    without += filled.isUsable(i) ? 0 : 1;
  }
  return without;
}
} // namespace

MadeResponse shapedResponse(const AxisymmetricTool& tool, const RegularGreen& green,
  const ShapedTerms& terms, const ResponseSpans& spans, const std::function<bool(double)>& goOn)
{
  const auto points = static_cast<std::size_t>(green.body().surface().pointTotal());
  const auto fitAt = [&](std::size_t i)
  {
    const auto point = static_cast<std::int32_t>(i);
    auto fit = std::make_unique<ContactKernelFit>(green, point);
    if (terms.meshes)
    {
      const BodySurface& surface = green.body().surface();
      fit->setMissed(terms.meshes->at(surface.position(point), surface.normal(point)));
    }
    return fit;
  };
  MadeResponse made = fillAll(tool, points, fitAt, terms, spans, goOn);
  if (made.complete)
  {
    fillEdges(edgesOf(green.body()), ResponseSampling(spans.samples, Exponent), spans);
    made.without = countWithout(points, spans);
  }
  return made;
}

MadeResponse shapedResponse(const AxisymmetricTool& tool, const LandmarkKernels& landmarks,
  const LandmarkSurface& surface, const ShapedTerms& terms, const ResponseSpans& spans,
  const std::function<bool(double)>& goOn)
{
  const auto blendAt = [&](std::size_t i)
  {
    const LandmarkSpot spot = surface.spotAt(i);
    auto blend = std::make_unique<BlendedKernels>(landmarks, spot.surface, spot.around);
    if (terms.meshes)
    {
      blend->setMissed(terms.meshes->at(spot.surface.place, spot.surface.normal));
    }
    return blend;
  };
  MadeResponse made = fillAll(tool, surface.edges.points, blendAt, terms, spans, goOn);
  if (made.complete)
  {
    fillEdges(surface.edges, ResponseSampling(spans.samples, Exponent), spans);
    made.without = countWithout(surface.edges.points, spans);
  }
  return made;
}
} // namespace palpate
