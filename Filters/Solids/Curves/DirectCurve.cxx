// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Curves/DirectCurve.h"

#include "Contact/ResponseContract.h"
#include "Laws/ErrorRule.h"
#include "Laws/TrustedDepth.h"
#include "Solids/TrueShape/StrainShare.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
/// Error of a force on which two meshes agree. It holds for four facets over the contact radius,
/// and for facets of an eighth of the radius at a rim (DirectContactTest).
constexpr double ErrorOfAgreement = 0.01;
/// Step of depth for the stiffness, as a fraction of the depth. It must not be too small, because a
/// contact grows corner by corner and the slope of the force jumps at each corner. The largest
/// depth plus the step must be within the range of DirectContact.
constexpr double StiffnessStep = 0.08;

/// Force and stiffness at one depth with their errors.
struct DirectSample
{
  double force = 0.0;
  double stiffness = 0.0;
  ErrorParts parts;
  double error = 1.0;
};

/// Mean of the contacts with the two directions of pressure (Pushed), after correction for finite
/// strain.
struct MeanOfPushes
{
  MeanOfPushes(const DirectContact& contact, const DirectTerms& terms, double depth)
  {
    const DirectForce mean = contact.at(depth, Pushed::TogetherAlongTheMean);
    const DirectForce own = contact.at(depth, Pushed::EachAlongItsOwn);
    this->small = 0.5 * (mean.force + own.force);
    this->open = 0.5 * std::abs(mean.force - own.force) / this->small;
    const double stiffness = 0.5 * (mean.stiffness + own.stiffness);
    if (!(this->small > 0.0 && stiffness > 0.0))
    {
      return;
    }
    const StrainShare share = strainShare(
      *terms.tool, terms.strain, terms.material, { this->small, stiffness, mean.radius });
    this->force = this->small + share.force - stiffness * share.deflection;
    this->strain = share.error;
  }
  double small = 0.0;  ///< force at small strain, N
  double open = 0.0;   ///< half of the relative difference of the two forces
  double force = 0.0;  ///< corrected force, N; 0 without a contact
  double strain = 0.0; ///< relative error of the correction for finite strain
};

/// Contacts on two meshes.
class TwoMeshes
{
public:
  TwoMeshes(const DirectPress& finer, const DirectPress& coarser, const DirectTerms& terms)
    : Finer(finer)
    , Coarser(coarser)
    , Terms(terms)
    , IsFinite(terms.solvesFiniteStrain)
  {
  }

  /// Returns whether both meshes have a contact.
  bool areFound() const { return this->isFound(this->Finer) && this->isFound(this->Coarser); }

  double forceAt(double depth) const
  {
    return this->IsFinite ? this->Finer.finite.evaluate(depth).force
                          : MeanOfPushes(*this->Finer.small, this->Terms, depth).force;
  }

  /// Returns the relative difference of the forces on the two meshes, before the correction for
  /// finite strain.
  double differenceAt(double depth) const
  {
    const double here = this->solvedOn(this->Finer, depth);
    const double other = this->solvedOn(this->Coarser, depth);
    return here > 0.0 && other > 0.0 ? std::abs(other / here - 1.0) : HUGE_VAL;
  }

  DirectSample at(double depth) const
  {
    return this->IsFinite ? this->atFiniteStrain(depth) : this->atSmallStrain(depth);
  }

private:
  bool isFound(const DirectPress& press) const
  {
    const double depth = this->Terms.depth;
    return this->IsFinite ? press.finite.deepest() >= depth
                          : press.small != nullptr && press.small->touchesBefore() <= depth;
  }

  double solvedOn(const DirectPress& press, double depth) const
  {
    return this->IsFinite ? press.finite.evaluate(depth).force
                          : MeanOfPushes(*press.small, this->Terms, depth).small;
  }

  DirectSample atFiniteStrain(double depth) const
  {
    const IndentationPoint found = this->Finer.finite.evaluate(depth);
    DirectSample made;
    made.force = found.force;
    made.stiffness = found.stiffness;
    made.parts[ResponseLimit::Elements] = std::hypot(this->differenceAt(depth), ErrorOfAgreement);
    made.parts[ResponseLimit::Strain] = this->Finer.finite.errorsAt(depth).strain;
    return made;
  }

  DirectSample atSmallStrain(double depth) const
  {
    const MeanOfPushes found(*this->Finer.small, this->Terms, depth);
    const double difference = this->differenceAt(depth);
    DirectSample made;
    if (!(found.force > 0.0 && std::isfinite(difference)))
    {
      return made;
    }
    const double less = this->forceAt(depth * (1.0 - StiffnessStep));
    const double more = this->forceAt(depth * (1.0 + StiffnessStep));
    made.force = found.force;
    made.stiffness = (more - less) / (2.0 * StiffnessStep * depth);
    made.parts[ResponseLimit::Strain] = found.strain;
    made.parts[ResponseLimit::Curvature] = found.open;
    made.parts[ResponseLimit::Elements] = std::hypot(difference, ErrorOfAgreement);
    return made;
  }

  const DirectPress& Finer;
  const DirectPress& Coarser;
  const DirectTerms& Terms;
  bool IsFinite;
};

void addUp(DirectSample& sample)
{
  const double error = sample.parts.norm();
  const bool isKnown = sample.force > 0.0 && sample.stiffness > 0.0 && std::isfinite(error);
  sample.error = isKnown ? error : 1.0;
}

/// The curve of the point before the replacement.
class FormerCurve
{
public:
  FormerCurve(std::size_t point, const ResponseSampling& sampling, const ResponseSpans& spans)
    : Sampling(sampling)
    , Range(static_cast<double>(spans.range[point]))
  {
    const auto n = static_cast<std::size_t>(spans.samples);
    const std::size_t first = n * point;
    this->Force.assign(spans.force + first, spans.force + first + n);
    this->Stiffness.assign(spans.stiffness + first, spans.stiffness + first + n);
    this->Error.assign(spans.error + first, spans.error + first + n);
  }

  ResponseValue at(double depth) const
  {
    return this->Sampling.evaluate(
      FloatCurve{ this->Force.data(), this->Stiffness.data() }, this->Range, depth);
  }

  /// Returns the stored error, or the relative difference from a more accurate force if this
  /// difference is larger.
  double errorAgainst(double force, double depth) const
  {
    return std::max(this->errorAt(depth), std::abs(this->at(depth).force / force - 1.0));
  }

  /// Returns the stored relative error; 1 if it is unknown.
  double errorAt(double depth) const
  {
    constexpr double rounding = 1.0 - 1e-6;
    if (!(rounding * depth <= this->Range))
    {
      return 1.0;
    }
    const double place =
      std::sqrt(rounding * depth / this->Range) * static_cast<double>(this->Error.size());
    const auto last = this->Error.size() - 1;
    const auto upper =
      std::min(static_cast<std::size_t>(std::max(std::ceil(place) - 1.0, 0.0)), last);
    const auto error = static_cast<double>(this->Error[upper]);
    return std::isfinite(error) ? error : 1.0;
  }

private:
  const ResponseSampling& Sampling;
  double Range;
  std::vector<float> Force;
  std::vector<float> Stiffness;
  std::vector<float> Error;
};

/// Fills a sample from the former curve, scaled such that the curve meets the first sample of the
/// direct curve.
void scaleFormer(const DirectSample& first, double depthOfFirst, const FormerCurve& former,
  double depth, DirectSample& sample)
{
  const ResponseValue was = former.at(depth);
  const ResponseValue wasThere = former.at(depthOfFirst);
  if (!(was.force > 0.0 && wasThere.force > 0.0))
  {
    const double power = first.stiffness * depthOfFirst / first.force;
    sample.force = first.force * std::pow(depth / depthOfFirst, power);
    sample.stiffness = power * sample.force / depth;
    sample.error = 1.0;
    return;
  }
  const double more = first.force / wasThere.force - 1.0;
  const double share = std::sqrt(depth / depthOfFirst);
  sample.force = was.force * (1.0 + more * share);
  sample.stiffness =
    was.stiffness * (1.0 + more * share) + was.force * more * share / (2.0 * depth);
  sample.error = std::max(former.errorAt(depth), std::abs(more) * share);
}
} // namespace

bool meshesAgree(const DirectPress& finer, const DirectPress& coarser, const DirectTerms& terms)
{
  const TwoMeshes contacts(finer, coarser, terms);
  return contacts.areFound() &&
    contacts.differenceAt(terms.depth) <= std::max(terms.errorTolerance, ErrorOfAgreement);
}

DirectOutcome takeDirectCurve(std::size_t point, const DirectPress& finer,
  const DirectPress& coarser, const DirectTerms& terms, const ResponseSampling& sampling,
  const ResponseSpans& spans)
{
  const TwoMeshes contacts(finer, coarser, terms);
  if (!contacts.areFound())
  {
    return DirectOutcome::Failed;
  }
  const FormerCurve former(point, sampling, spans);
  const auto n = static_cast<std::size_t>(spans.samples);
  std::vector<DirectSample> samples(n);
  std::size_t first = n;
  for (std::size_t k = n; k-- > 0;)
  {
    const double depth = sampling.depth(static_cast<int>(k), terms.depth);
    samples[k] = contacts.at(depth);
    addUp(samples[k]);
    if (samples[k].error >= 1.0 ||
      samples[k].error >= former.errorAgainst(samples[k].force, depth) ||
      (first < n && samples[k].force >= samples[first].force))
    {
      break;
    }
    first = k;
  }
  if (first == n)
  {
    return samples.back().error >= 1.0 ? DirectOutcome::Failed : DirectOutcome::Kept;
  }
  float* force = spans.force + n * point;
  float* stiffness = spans.stiffness + n * point;
  float* errors = spans.error + n * point;
  const auto formerLimit = static_cast<ResponseLimit>(spans.limit[point]);
  const double depthOfFirst = sampling.depth(static_cast<int>(first), terms.depth);
  for (std::size_t k = 0; k < n; ++k)
  {
    if (k < first)
    {
      scaleFormer(samples[first], depthOfFirst, former,
        sampling.depth(static_cast<int>(k), terms.depth), samples[k]);
      samples[k].parts = {};
      samples[k].parts[formerLimit] = samples[k].error;
    }
    force[k] = static_cast<float>(samples[k].force);
    stiffness[k] = static_cast<float>(samples[k].stiffness);
  }
  spans.range[point] = static_cast<float>(terms.depth);
  spans.status[point] = static_cast<unsigned char>(ResponseStatus::Valid);
  ResponseLimit limit = ResponseLimit::None;
  TrustedDepth trusted(terms.depth, n, terms.errorTolerance);
  for (std::size_t k = n; k-- > 0;)
  {
    if (k > first)
    {
      const double root = (static_cast<double>(k) + 0.5) / static_cast<double>(n);
      const double depth = terms.depth * root * root;
      const double stored =
        sampling.evaluate(FloatCurve{ force, stiffness }, terms.depth, depth).force;
      samples[k].parts[ResponseLimit::None] = std::abs(stored / contacts.forceAt(depth) - 1.0);
      addUp(samples[k]);
    }
    errors[k] = static_cast<float>(samples[k].error);
    if (!trusted.add(k + 1, samples[k].error))
    {
      limit = samples[k].parts.largest();
    }
  }
  spans.validity[point] = static_cast<float>(trusted.depth());
  spans.limit[point] = static_cast<unsigned char>(limit);
  return DirectOutcome::Replaced;
}
} // namespace palpate
