// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/RelaxingIdentification.h"

#include "Mechanics/Files/NumberText.h"
#include "Identification/FitReport.h"
#include "Identification/FitVerdict.h"
#include "Identification/RelaxationFit.h"
#include "Identification/StrainWindow.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace palpate
{
namespace
{
using Eigen::Index;

// Relative width of the confidence interval of E* above which a remark is made.
constexpr double WideInterval = 0.2;

std::string seconds(double time)
{
  return shortly(time) + " s";
}

/// Returns the number of readings that are compared with the fit.
std::size_t countOf(const PressHistory& history)
{
  return static_cast<std::size_t>(
    std::accumulate(history.readings.begin(), history.readings.end(), 0.0));
}

/// Identifies a relaxing body at one site.
class Identifier
{
public:
  Identifier(const BodyIdentification& identification, std::vector<PressHistory> histories)
    : Identification(identification)
    , Options(identification.options())
    , All(std::move(histories))
    , Used(this->All)
  {
  }

  IdentifiedBody identify()
  {
    IdentifiedBody result;
    result.refusal = this->All.empty() ? "there is no loading" : "";
    result.refusal = result.refusal.empty() ? this->judge() : result.refusal;
    // Which readings are within small strain depends on the body. Therefore the fit and the
    // selection of readings alternate.
    for (int pass = 0; pass < FitLimits::LargestPassCount && this->Fit && this->selectReadings();
         ++pass)
    {
      const std::optional<RelaxationFit> before = this->Fit;
      const std::string fault = this->judge();
      if (!this->Fit) // the remaining readings do not determine a body
      {
        this->Fit = before;
        result.refusal = result.refusal.empty() ? fault : result.refusal;
        break;
      }
      result.refusal = fault;
    }
    if (this->Fit)
    {
      result.noise = this->Noise.deviation;
      result.misfit = this->Fit->residual();
      result.largestForce = this->LargestForce;
      result.withinNoise = this->WithinNoise;
    }
    if (this->isHoldTooDeep())
    {
      result.refusal += (result.refusal.empty() ? "" : "; ") +
        std::string("its longest hold lies deeper than small strain allows, and E* cannot be "
                    "determined without this hold: hold less deep, or allow more strain");
    }
    if (result.refusal.empty())
    {
      this->report(result);
    }
    return result;
  }

private:
  bool isGiven() const { return this->Options.relaxation.count > 0; }

  std::string judge()
  {
    this->LargestForce = 0.0;
    double squares = 0.0;
    double freedom = 0.0;
    for (std::size_t c = 0; c < this->Used.size(); ++c)
    {
      const PressHistory& history = this->Used[c];
      for (std::size_t i = 0; i < history.size(); ++i)
      {
        this->LargestForce =
          std::max(this->LargestForce, history.readings[i] > 0.0 ? history.netForce(i) : 0.0);
      }
      const std::size_t count = countOf(history);
      if (count < BodyIdentification::FewestReadings)
      {
        return tooFew(count, countOf(this->All[c]), this->Options.largestStrain);
      }
      std::string unusable = checkLoading(history.loading);
      if (!unusable.empty())
      {
        return unusable;
      }
      squares += history.noise.degreesOfFreedom * history.noise.deviation * history.noise.deviation;
      freedom += history.noise.degreesOfFreedom;
    }
    if (!(this->LargestForce > 0.0))
    {
      return "no force is above 0";
    }
    this->Noise = this->Options.noise > 0.0 ? ForceNoise{ this->Options.noise }
                                            : ForceNoise{ std::sqrt(squares / freedom), freedom };
    this->Coarse = this->Noise;
    this->Coarse.deviation =
      std::max(this->Noise.deviation, FitLimits::LeastNoise * this->LargestForce);
    const std::string fault = this->choose();
    if (!fault.empty())
    {
      return fault;
    }
    const double misfit = this->Fit->residual();
    const double allowed = this->Options.largestMisfit * this->LargestForce;
    if (!this->WithinNoise && !(misfit <= allowed))
    {
      return "no model fits: the nearest, a relaxing " +
        std::string(nameOf(this->Fit->body.model)) + ", leaves a residual of " + shortly(misfit) +
        " N, more than the noise of " + shortly(this->Noise.deviation) + " N and the " +
        shortly(allowed) + " N allowed";
    }
    const double left =
      std::max({ this->Noise.deviation, misfit, FitLimits::LeastError * this->LargestForce });
    const std::string unclear = this->checkDetermined(left);
    return unclear.empty() ? checkBaseline(this->loadings(), *this->Fit, this->Coarse,
                               studentQuantile(this->Fit->degreesOfFreedom) * left, allowed)
                           : unclear;
  }

  void choose(std::optional<RelaxationFit> fit)
  {
    this->Fit = std::move(fit);
    this->WithinNoise = this->Fit && leavesNoise(*this->Fit, this->Coarse);
  }

  std::string choose()
  {
    const auto fitted = [&](BodyModel model)
    {
      return fitRelaxingBody(this->Used, model, this->Options.findContact,
        this->Identification.kernel(), this->Coarse.deviation, this->Options.relaxation);
    };
    const auto none = [](BodyModel model)
    { return noBody(std::string("relaxing ") + nameOf(model)); };
    this->choose(fitted(this->Options.model.value_or(BodyModel::HalfSpace)));
    if (this->Options.model)
    {
      return this->Fit ? std::string() : none(*this->Options.model);
    }
    std::vector<RelaxationFit> richer;
    for (const BodyModel model : { BodyModel::GlobalCompliance, BodyModel::Layer })
    {
      std::optional<RelaxationFit> fit = fitted(model);
      const bool isBody = fit && fit->converged && fit->separation >= FitLimits::Inseparable;
      if (isBody && (model != BodyModel::GlobalCompliance || fit->body.compliance > 0.0))
      {
        richer.push_back(std::move(*fit));
      }
    }
    std::sort(richer.begin(), richer.end(),
      [](const RelaxationFit& a, const RelaxationFit& b) { return a.score < b.score; });
    if (richer.empty() || (this->Fit && !(richer.front().score < this->Fit->score)))
    {
      if (!this->Fit)
      {
        return none(BodyModel::HalfSpace);
      }
      const double error = studentQuantile(this->Fit->degreesOfFreedom) * this->Coarse.deviation *
        modulusErrorBesideCompliance(
          this->Used, *this->Fit, this->Options.findContact, this->isGiven());
      return error <= this->Options.largestUncertainty ? std::string()
        : this->isFlatOnly()                           ? std::string(FlatAlone)
                             : "the curves do not distinguish E* from a global compliance";
    }
    if (richer.size() > 1 && leavesNoise(richer[0], this->Coarse) &&
      leavesNoise(richer[1], this->Coarse) &&
      richer[1].score - richer[0].score < FitLimits::LikelihoodRatio)
    {
      return "the curves do not distinguish a global compliance from a layer";
    }
    this->choose(richer.front());
    return {};
  }

  std::string checkDetermined(double noise) const
  {
    const RelaxationFit& fit = *this->Fit;
    const double longest = windowOf(this->Used, fit.contactOffset).longest;
    const bool goesOn = !this->isGiven() && fit.series.count > 0 &&
      fit.series.time[fit.series.count - 1] > 0.3 * longest;
    const std::string advice = goesOn
      ? ": the force has not come to rest after " + seconds(longest) + "; hold longer"
      : std::string();
    const std::string what = std::string("a relaxing ") + nameOf(fit.body.model);
    if (!fit.converged)
    {
      return "the fit of " + what + " does not converge" + advice;
    }
    if (fit.separation < FitLimits::Inseparable)
    {
      return this->isFlatOnly() && fit.body.model != BodyModel::HalfSpace
        ? std::string(FlatAlone)
        : "the curves do not determine the parameters of " + what + " separately" + advice;
    }
    const double width = studentQuantile(fit.degreesOfFreedom) * noise;
    const std::string fault = checkCompliance(fit, width);
    if (!fault.empty())
    {
      return fault;
    }
    const double error = width * fit.errorPerNoise[0];
    if (!(error <= this->Options.largestUncertainty))
    {
      return "the slow E* is known to " + shortly(100.0 * error) + " % only, but " +
        shortly(100.0 * this->Options.largestUncertainty) + " % is required" + advice;
    }
    return {};
  }

  std::vector<IndentationCurve> loadings() const
  {
    std::vector<IndentationCurve> loadings;
    for (const PressHistory& history : this->Used)
    {
      loadings.push_back(history.loading);
    }
    return loadings;
  }

  bool isFlatOnly() const
  {
    return std::all_of(this->Used.begin(), this->Used.end(),
      [](const PressHistory& history) { return isFlat(*history.tool); });
  }

  /// Excludes readings that are too deep for a linear law. Returns whether the selection has
  /// changed.
  bool selectReadings()
  {
    bool changed = false;
    const BodyParameters& body = this->Fit->body;
    for (std::size_t c = 0; c < this->All.size(); ++c)
    {
      const PressHistory& all = this->All[c];
      const double local = smallStrainDepth(
        *all.tool, body, this->Identification.kernel(), this->Options.largestStrain);
      const double given = body.compliance > 0.0 && std::isfinite(local) ? body.compliance *
          localContact(body, *all.tool, this->Identification.kernel(), local).force
                                                                         : 0.0;
      PressHistory& used = this->Used[c];
      for (std::size_t i = 0; i < all.size(); ++i)
      {
        const bool isKept = all.deflection[i] - this->Fit->contactOffset[c] - given <= local;
        const double readings = isKept ? all.readings[i] : 0.0;
        changed = changed || readings != used.readings[i];
        used.readings[i] = readings;
      }
    }
    return changed;
  }

  /// Returns whether more than half of the test's longest time in contact is excluded because of
  /// its strain.
  bool isHoldTooDeep() const
  {
    return !this->isGiven() && this->Fit &&
      windowOf(this->Used, this->Fit->contactOffset).longest <
      0.5 * windowOf(this->All, this->Fit->contactOffset).longest;
  }

  /// Stores the parameters of the fit with their confidence intervals, and the end of the data.
  void report(IdentifiedBody& result) const
  {
    const RelaxationFit& fit = *this->Fit;
    const double width = intervalWidth(fit, this->Options.noise > 0.0, result);
    const auto error = [&](Index at) { return width * fit.errorPerNoise[at]; };
    const Index next = reportBody(fit, width, this->Options.findContact, result);
    result.relaxation = fit.series;
    const auto branches = static_cast<Index>(fit.series.count);
    for (Index i = 0; i < branches; ++i)
    {
      const auto branch = static_cast<std::size_t>(i);
      result.relaxationStrength.push_back(
        logarithmicEstimate(fit.series.strength[branch], this->isGiven() ? 0.0 : error(next + i)));
      result.relaxationTime.push_back(logarithmicEstimate(
        fit.series.time[branch], this->isGiven() ? 0.0 : error(next + branches + i)));
    }
    this->findEnd(result);
    const TimeWindow window = windowOf(this->Used, fit.contactOffset);
    result.shortestTime = window.shortest;
    result.longestTime = window.longest;
    result.remark = this->isGiven() ? "relaxation given" : this->remarkOn(result, error(0));
    std::size_t left = 0;
    std::size_t total = 0;
    for (std::size_t c = 0; c < this->Used.size(); ++c)
    {
      total += countOf(this->All[c]);
      left += countOf(this->All[c]) - countOf(this->Used[c]);
    }
    for (const std::string& more : { leftOut(left, total, this->Options.largestStrain),
           undeterminedBaseline(fit, this->Options.findContact) })
    {
      result.remark += (more.empty() ? "" : "; ") + more;
    }
  }

  void findEnd(IdentifiedBody& result) const
  {
    for (std::size_t c = 0; c < this->Used.size(); ++c)
    {
      const PressHistory& history = this->Used[c];
      double deepest = -std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < history.size(); ++i)
      {
        deepest = history.readings[i] > 0.0 ? std::max(deepest, history.deflection[i]) : deepest;
      }
      reportEnd(*history.tool, this->Identification.kernel(), deepest - this->Fit->contactOffset[c],
        result);
    }
  }

  /// Describes the relaxation times that the test resolves, and those that it does not resolve.
  std::string remarkOn(const IdentifiedBody& result, double modulusError) const
  {
    const PronySeries& series = result.relaxation;
    std::string text = "times from " + seconds(result.shortestTime) + " to " +
      seconds(result.longestTime) +
      " are determined; relaxation that is faster or slower than the test is not";
    for (std::size_t i = 0; i < series.count; ++i)
    {
      const Estimate& time = result.relaxationTime[i];
      if (time.value > result.longestTime)
      {
        text += "; the time of " + seconds(time.value) + " (" + seconds(time.lower) + " to " +
          seconds(time.upper) + ") is longer than the test, so that E* depends on an extrapolation";
      }
      else if (time.value < result.shortestTime)
      {
        text += "; of the branch of " + seconds(time.value) +
          " the product of strength and time is known, but hardly each of the two";
      }
    }
    if (modulusError > WideInterval)
    {
      text += "; E* is known to " + shortly(100.0 * modulusError) +
        " % only, because the force has not come to rest: hold longer";
    }
    return text;
  }

  const BodyIdentification& Identification;
  const IdentificationOptions& Options;
  std::vector<PressHistory> All;
  std::vector<PressHistory> Used;
  ForceNoise Noise;
  ForceNoise Coarse; ///< the noise, but at least the error of a law
  std::optional<RelaxationFit> Fit;
  double LargestForce = 0.0;
  bool WithinNoise = false;
};
} // namespace

IdentifiedBody identifyRelaxing(
  const BodyIdentification& identification, std::vector<PressHistory> histories)
{
  return Identifier(identification, std::move(histories)).identify();
}
} // namespace palpate
