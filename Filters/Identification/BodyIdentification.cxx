// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/BodyIdentification.h"

#include "Mechanics/Files/NumberText.h"
#include "Identification/ArrangedReadings.h"
#include "Identification/FitReport.h"
#include "Identification/FitVerdict.h"
#include "Identification/StrainWindow.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace palpate
{
namespace
{
using FitLimits::Inseparable;
using FitLimits::LargestPassCount;
using FitLimits::LeastError;
using FitLimits::LeastNoise;
using FitLimits::LikelihoodRatio;

void sortByDepth(IndentationCurve& curve)
{
  std::vector<std::size_t> order(curve.deflection.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&curve](std::size_t a, std::size_t b) { return curve.deflection[a] < curve.deflection[b]; });
  IndentationCurve sorted;
  sorted.tool = curve.tool;
  for (const std::size_t i : order)
  {
    sorted.deflection.push_back(curve.deflection[i]);
    sorted.force.push_back(curve.force[i]);
  }
  curve = std::move(sorted);
}

/// Returns the common noise of all curves, N.
ForceNoise poolNoise(const std::vector<IndentationCurve>& curves)
{
  double squares = 0.0;
  double freedom = 0.0;
  for (const IndentationCurve& curve : curves)
  {
    const ForceNoise noise = estimateForceNoise(curve.deflection, curve.force);
    squares += noise.degreesOfFreedom * noise.deviation * noise.deviation;
    freedom += noise.degreesOfFreedom;
  }
  return { std::sqrt(squares / freedom), freedom };
}

std::string checkCurve(const IndentationCurve& curve)
{
  if (curve.force.size() < BodyIdentification::FewestReadings)
  {
    return tooFew(curve.force.size(), curve.force.size(), 0.0);
  }
  const auto [low, high] = std::minmax_element(curve.deflection.begin(), curve.deflection.end());
  if (!(*high > *low))
  {
    return "the deflection stays at " + shortly(*low) + " mm";
  }
  const auto [least, most] = std::minmax_element(curve.force.begin(), curve.force.end());
  if (!(*most > *least))
  {
    return "the force stays at " + shortly(*least) + " N";
  }
  return {};
}

bool isFlatOnly(const std::vector<IndentationCurve>& curves)
{
  return std::all_of(curves.begin(), curves.end(),
    [](const IndentationCurve& curve) { return isFlat(*curve.tool); });
}
} // namespace

const char* nameOf(BodyModel model)
{
  switch (model)
  {
    case BodyModel::GlobalCompliance:
      return "half-space in series with global compliance";
    case BodyModel::Layer:
      return "layer on a rigid base";
    default:
      return "half-space";
  }
}

BodyIdentification::BodyIdentification(const IdentificationOptions& options)
  : Options(options)
  , Kernel(LayerKernel::shared(options.poissonRatio, options.base))
{
}

/// Returns "" if the curves determine the body of the fit, else the reason why they do not.
std::string BodyIdentification::checkDetermined(
  const std::vector<IndentationCurve>& curves, const BodyFit& fit, double noise) const
{
  if (!fit.converged)
  {
    return std::string("the fit of a ") + nameOf(fit.body.model) + " does not converge";
  }
  if (fit.separation < Inseparable)
  {
    return isFlatOnly(curves) ? FlatAlone
                              : std::string("the curves do not determine the parameters of a ") +
        nameOf(fit.body.model) + " separately";
  }
  const double width = studentQuantile(fit.degreesOfFreedom) * noise;
  std::string fault = checkCompliance(fit, width);
  if (!fault.empty())
  {
    return fault;
  }
  const double error = width * fit.errorPerNoise[0];
  if (!(error <= this->Options.largestUncertainty))
  {
    return "E* is known to " + shortly(100.0 * error) + " % only, but " +
      shortly(100.0 * this->Options.largestUncertainty) + " % is required";
  }
  return {};
}

/// Chooses a model. Returns the reason if no model can be chosen, else "".
std::string BodyIdentification::choose(
  const std::vector<IndentationCurve>& curves, const ForceNoise& noise, Judgement& judgement) const
{
  const IdentificationOptions& options = this->Options;
  const auto fitted = [&](BodyModel model)
  { return fitBody(curves, model, options.findContact, this->Kernel); };
  std::optional<BodyFit>& chosen = judgement.fit;
  const auto choose = [&](std::optional<BodyFit> fit)
  {
    chosen = std::move(fit);
    judgement.withinNoise = chosen && leavesNoise(*chosen, noise);
  };
  choose(fitted(options.model.value_or(BodyModel::HalfSpace)));
  if (options.model)
  {
    return chosen ? std::string() : noBody(nameOf(*options.model));
  }
  std::vector<BodyFit> richer;
  for (const BodyModel model : { BodyModel::GlobalCompliance, BodyModel::Layer })
  {
    std::optional<BodyFit> fit = fitted(model);
    const bool isBody = fit && fit->converged && fit->separation >= Inseparable;
    if (isBody && (model != BodyModel::GlobalCompliance || fit->body.compliance > 0.0))
    {
      richer.push_back(std::move(*fit));
    }
  }
  std::sort(richer.begin(), richer.end(),
    [](const BodyFit& a, const BodyFit& b) { return a.sumOfSquares < b.sumOfSquares; });

  const double significant = LikelihoodRatio * noise.deviation * noise.deviation;
  const bool improved = !richer.empty() &&
    (!chosen || chosen->sumOfSquares - richer.front().sumOfSquares > significant);
  if (!improved)
  {
    if (!chosen)
    {
      return noBody(nameOf(BodyModel::HalfSpace));
    }
    const double error = studentQuantile(chosen->degreesOfFreedom) * noise.deviation *
      modulusErrorBesideCompliance(curves, *chosen, options.findContact);
    return error <= options.largestUncertainty ? std::string()
      : isFlatOnly(curves)                     ? std::string(FlatAlone)
                           : "the curves do not distinguish E* from a global compliance";
  }
  if (richer.size() > 1 && leavesNoise(richer[0], noise) && leavesNoise(richer[1], noise) &&
    richer[1].sumOfSquares - richer[0].sumOfSquares < significant)
  {
    return "the curves do not distinguish a global compliance from a layer";
  }
  choose(richer.front());
  return {};
}

/// Identifies a body from the given readings, which are not changed. Returns the reason on failure,
/// else "".
std::string BodyIdentification::judge(
  const std::vector<IndentationCurve>& curves, const ForceNoise& noise, Judgement& judgement) const
{
  double force = 0.0;
  for (const IndentationCurve& curve : curves)
  {
    std::string unusable = checkLoading(curve);
    if (!unusable.empty())
    {
      return unusable;
    }
    force = std::max(force, curve.largestForce());
  }
  judgement.largestForce = force;
  const ForceNoise coarse{ std::max(noise.deviation, LeastNoise * force), noise.degreesOfFreedom };
  const std::string fault = this->choose(curves, coarse, judgement);
  if (!fault.empty())
  {
    return fault;
  }
  const double misfit = judgement.fit->residual();
  const double allowed = this->Options.largestMisfit * force;
  if (!judgement.withinNoise && !(misfit <= allowed))
  {
    return "no model fits: the nearest, a " + std::string(nameOf(judgement.fit->body.model)) +
      ", leaves a residual of " + shortly(misfit) + " N, more than the noise of " +
      shortly(noise.deviation) + " N and the " + shortly(allowed) + " N allowed";
  }
  const double left = std::max({ noise.deviation, misfit, LeastError * force });
  const std::string unclear = this->checkDetermined(curves, *judgement.fit, left);
  return unclear.empty() ? checkBaseline(curves, *judgement.fit, coarse,
                             studentQuantile(judgement.fit->degreesOfFreedom) * left, allowed)
                         : unclear;
}

/// Selects the readings of all curves that are within small strain, arranges and counts these
/// readings. Returns the reason if there are too few, else "".
std::string BodyIdentification::select(const std::vector<IndentationCurve>& all, const BodyFit& fit,
  std::vector<IndentationCurve>& used, std::size_t& count) const
{
  count = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const IndentationCurve kept = readingsWithin(all[i], fit.body, fit.contactOffset[i],
      fit.baseline[i], this->Kernel, this->Options.largestStrain);
    if (kept.force.size() < FewestReadings)
    {
      return tooFew(kept.force.size(), all[i].force.size(), this->Options.largestStrain);
    }
    count += kept.force.size();
    used[i] = arrangeReadings(kept, this->Options.findContact);
  }
  return {};
}

IdentifiedBody BodyIdentification::identify(std::vector<IndentationCurve> curves) const
{
  IdentifiedBody result;
  result.refusal = curves.empty() ? "there is no loading" : "";
  std::size_t count = 0; // total number of readings used
  for (IndentationCurve& curve : curves)
  {
    result.refusal = result.refusal.empty() ? checkCurve(curve) : result.refusal;
    count += curve.force.size();
    if (result.refusal.empty())
    {
      sortByDepth(curve);
    }
  }
  if (!result.refusal.empty())
  {
    return result;
  }
  const std::size_t total = count;
  const bool given = this->Options.noise > 0.0;
  const ForceNoise noise = given ? ForceNoise{ this->Options.noise } : poolNoise(curves);
  std::vector<IndentationCurve> used;
  for (const IndentationCurve& curve : curves)
  {
    used.push_back(arrangeReadings(curve, this->Options.findContact));
  }

  // Which readings are within small strain depends on the body. Therefore the fit and the selection
  // of readings alternate.
  Judgement judgement;
  result.refusal = this->judge(used, noise, judgement);
  for (int pass = 0; pass < LargestPassCount && judgement.fit; ++pass)
  {
    const std::size_t before = count;
    const std::string fault = this->select(curves, *judgement.fit, used, count);
    if (!fault.empty())
    {
      result.refusal = fault;
      return result;
    }
    if (count == before)
    {
      break;
    }
    result.refusal = this->judge(used, noise, judgement);
  }
  const std::string left = leftOut(total - count, total, this->Options.largestStrain);
  result.noise = noise.deviation;
  result.largestForce = judgement.largestForce;
  if (judgement.fit)
  {
    result.misfit = judgement.fit->residual();
    result.withinNoise = judgement.withinNoise;
  }
  if (result.refusal.empty())
  {
    this->report(used, given, *judgement.fit, result);
    const std::string missing = undeterminedBaseline(*judgement.fit, this->Options.findContact);
    result.remark = left + (left.empty() || missing.empty() ? "" : "; ") + missing;
  }
  else if (!left.empty())
  {
    result.refusal += "; " + left;
  }
  return result;
}

/// Stores the parameters of the fit with their confidence intervals, and the end of the data.
void BodyIdentification::report(const std::vector<IndentationCurve>& curves, bool noiseGiven,
  const BodyFit& fit, IdentifiedBody& result) const
{
  reportBody(fit, intervalWidth(fit, noiseGiven, result), this->Options.findContact, result);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    reportEnd(
      *curves[i].tool, this->Kernel, curves[i].deflection.back() - fit.contactOffset[i], result);
  }
}
} // namespace palpate
