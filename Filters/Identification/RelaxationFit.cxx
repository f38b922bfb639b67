// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/RelaxationFit.h"

#include "Identification/FitVerdict.h"
#include "Identification/LeastSquares.h"
#include "Identification/RelaxationResiduals.h"
#include "Identification/RelaxationStart.h"
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
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double BranchRatio = 9.210; // 1 % limit of χ² with two degrees of freedom
// Additional penalty for branches that are not determined. Noise exceeds the total penalty once in
// a million fits.
constexpr double Doubt = 2.0 * BranchRatio;
// Smallest ratio of neighbouring relaxation times. Branches with a smaller ratio are merged.
constexpr double LeastTimeRatio = 1.5;
constexpr std::size_t CoarseBlocks = 1;

/// Condition at which a fit ends: a relative step, or a number of evaluations.
struct Ending
{
  double tolerance;
  int evaluations;
};
// The number of evaluations is limited, because the fit does not converge if there are too many
// branches.
constexpr Ending Coarse{ 1e-4, 30 };
constexpr Ending Fine{ 1e-7, 200 }; // far below the uncertainty due to noise

/// Returns the initial bodies of fits: the elastic body fitted to the loadings, and a body whose
/// deformation is nearly local.
std::vector<RelaxingBody> startingBodies(const std::vector<PressHistory>& histories,
  BodyModel model, bool findContact, const std::shared_ptr<const LayerKernel>& kernel)
{
  std::vector<IndentationCurve> loads;
  loads.reserve(histories.size());
  for (const PressHistory& history : histories)
  {
    loads.push_back(history.loading);
  }
  std::vector<RelaxingBody> starts;
  const auto add = [&](const BodyFit& fit)
  {
    if (fit.body.reducedModulus > 0.0 && std::isfinite(fit.body.reducedModulus))
    {
      starts.push_back({ fit.body, {}, fit.contactOffset, fit.baseline });
    }
  };
  std::optional<BodyFit> halfSpace = fitBody(loads, BodyModel::HalfSpace, findContact, kernel);
  if (halfSpace && model == BodyModel::HalfSpace)
  {
    add(*halfSpace);
  }
  if (model == BodyModel::HalfSpace)
  {
    return starts;
  }
  const std::optional<BodyFit> fit = fitBody(loads, model, findContact, kernel);
  // The compliance is negative if the speed increased during the loading.
  if (fit && !(fit->body.compliance < 0.0))
  {
    add(*fit);
  }
  if (halfSpace)
  {
    const IndentationCurve& load = loads.front();
    const double depth = load.deflection.back() - halfSpace->contactOffset.front();
    if (model == BodyModel::GlobalCompliance)
    {
      halfSpace->body.compliance = 0.2 * depth /
        bodyResponse(
          { BodyModel::HalfSpace, halfSpace->body.reducedModulus }, *load.tool, kernel, depth)
          .force;
      halfSpace->body.reducedModulus *= 1.5;
    }
    else
    {
      halfSpace->body.thickness = 3.0 * load.tool->contactRadius(depth);
      halfSpace->body.reducedModulus *= 0.6;
    }
    halfSpace->body.model = model;
    add(*halfSpace);
  }
  return starts;
}

void sortBranches(
  PronySeries& series, Eigen::Ref<VectorXd> strengthErrors, Eigen::Ref<VectorXd> timeErrors)
{
  std::vector<std::size_t> order(series.count);
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::sort(order.begin(), order.end(),
    [&series](std::size_t a, std::size_t b) { return series.time[a] < series.time[b]; });
  const PronySeries before = series;
  const VectorXd strengths = strengthErrors;
  const VectorXd times = timeErrors;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const auto to = static_cast<Index>(i);
    const auto from = static_cast<Index>(order[i]);
    series.strength[i] = before.strength[order[i]];
    series.time[i] = before.time[order[i]];
    strengthErrors[to] = strengths[from];
    timeErrors[to] = times[from];
  }
}

bool areApart(const PronySeries& series)
{
  for (std::size_t i = 0; i + 1 < series.count; ++i)
  {
    if (series.time[i + 1] < LeastTimeRatio * series.time[i])
    {
      return false;
    }
  }
  return true;
}

/// Returns whether the readings determine all branches of the fit to within a factor of twenty.
bool isDetermined(const RelaxationFit& fit, double noise)
{
  const auto branches = static_cast<Index>(fit.series.count);
  return fit.converged && fit.separation >= FitLimits::Inseparable &&
    fit.errorPerNoise.tail(2 * branches).maxCoeff() * noise * Normal95 < std::log(20.0);
}

/// Fits a relaxing body, starting from one initial body. Returns no value on failure.
std::optional<RelaxationFit> fitFrom(const std::vector<PressHistory>& histories,
  const RelaxationProblem& problem, const RelaxingBody& start, Ending ending)
{
  RelaxationResiduals residuals(histories, problem);
  RelaxationFit fit;
  fit.degreesOfFreedom = static_cast<int>(residuals.values() - residuals.inputs());
  VectorXd p = residuals.pack(start);
  if (fit.degreesOfFreedom < 1 || !p.allFinite())
  {
    return std::nullopt;
  }
  const Minimum minimum = minimize(residuals, p, ending.tolerance, ending.evaluations);
  if (!p.allFinite() || !PackedBody::isBody(minimum.squares))
  {
    return std::nullopt;
  }
  const RelaxingBody found = residuals.unpack(p);
  fit.body = found.body;
  fit.series = found.series;
  fit.contactOffset = found.contactOffset;
  fit.baseline = found.baseline;
  for (const PressHistory& history : histories)
  {
    fit.terms.push_back(history.loading.start.terms);
  }
  fit.sumOfSquares = minimum.squares * residuals.force() * residuals.force();
  fit.converged = minimum.converged;
  MatrixXd jacobian(residuals.values(), residuals.inputs());
  residuals.df(p, jacobian);
  residuals.judge(jacobian, fit);
  const auto branches = static_cast<Index>(problem.branches);
  if (branches > 0)
  {
    sortBranches(fit.series, fit.errorPerNoise.segment(residuals.firstStrength(), branches),
      fit.errorPerNoise.tail(branches));
  }
  return fit;
}
} // namespace

std::optional<RelaxationFit> fitRelaxingBody(const std::vector<PressHistory>& histories,
  BodyModel model, bool findContact, const std::shared_ptr<const LayerKernel>& kernel, double noise,
  const PronySeries& given)
{
  RelaxationProblem problem;
  problem.model = model;
  problem.findContact = findContact;
  problem.kernel = kernel;
  problem.given = given;
  const auto score = [&](const RelaxationFit& fit)
  {
    const double body = model == BodyModel::HalfSpace ? 0.0 : FitLimits::LikelihoodRatio;
    return fit.sumOfSquares / (noise * noise) + body +
      BranchRatio * static_cast<double>(problem.branches);
  };

  std::optional<RelaxationFit> best;
  problem.blocks = CoarseBlocks;
  const auto spectrumAt = [&](const RelaxingBody& about)
  { return startingSpectrum(histories, about, kernel, windowOf(histories, about.contactOffset)); };
  for (RelaxingBody start : startingBodies(histories, model, findContact, kernel))
  {
    RelaxationSpectrum spectrum;
    if (given.count == 0)
    {
      spectrum = spectrumAt(start).merged(2);
      if (spectrum.time.empty())
      {
        continue;
      }
      start = withSpectrum(start, spectrum);
    }
    else
    {
      start.series = given;
      start.body.reducedModulus /= 1.0 + 0.5 * given.total();
      start.body.compliance *= 1.0 + 0.5 * given.total();
    }
    problem.branches = spectrum.time.size();
    std::optional<RelaxationFit> fit = fitFrom(histories, problem, start, Coarse);
    if (fit && (!best || fit->sumOfSquares < best->sumOfSquares))
    {
      best = std::move(fit);
    }
  }
  if (!best)
  {
    return std::nullopt;
  }
  const RelaxingBody about{ best->body, best->series, best->contactOffset, best->baseline };
  if (given.count == 0)
  {
    // Determines the number of branches. Each additional branch must reduce the score.
    const RelaxationSpectrum spectrum = spectrumAt(about);
    std::optional<RelaxationFit> chosen;
    for (std::size_t k = 1; k <= std::min(spectrum.time.size(), PronySeries::LargestCount); ++k)
    {
      problem.branches = k;
      std::optional<RelaxationFit> fit = k == best->series.count
        ? best
        : fitFrom(histories, problem, withSpectrum(about, spectrum.merged(k)), Coarse);
      if (!fit)
      {
        continue;
      }
      fit->score = score(*fit);
      const double doubt = isDetermined(*fit, noise) ? 0.0 : Doubt;
      if (chosen && !(fit->score + doubt < chosen->score && areApart(fit->series)))
      {
        break;
      }
      chosen = std::move(fit);
    }
    best = chosen ? chosen : best;
    problem.branches = best->series.count;
  }
  problem.blocks = RelaxationProblem().blocks;
  best = fitFrom(
    histories, problem, { best->body, best->series, best->contactOffset, best->baseline }, Fine);
  if (best)
  {
    best->score = score(*best);
  }
  return best;
}

double modulusErrorBesideCompliance(const std::vector<PressHistory>& histories,
  const RelaxationFit& halfSpace, bool findContact, bool isSeriesGiven)
{
  RelaxationProblem problem;
  problem.model = BodyModel::GlobalCompliance;
  problem.findContact = findContact;
  problem.branches = isSeriesGiven ? 0 : halfSpace.series.count;
  problem.given = halfSpace.series;
  const RelaxationResiduals residuals(histories, problem);
  MatrixXd jacobian(residuals.values(), residuals.inputs());
  BodyParameters body = halfSpace.body;
  body.model = BodyModel::GlobalCompliance;
  residuals.df(
    residuals.pack({ body, halfSpace.series, halfSpace.contactOffset, halfSpace.baseline }),
    jacobian);
  return residuals.modulusError(jacobian);
}

std::vector<double> forcesOver(const PressHistory& history, const BodyParameters& body,
  const PronySeries& series, const std::shared_ptr<const LayerKernel>& kernel, double offset)
{
  std::vector<double> forces(history.size(), 0.0);
  const double depth =
    *std::max_element(history.deflection.begin(), history.deflection.end()) - offset;
  if (depth > 0.0)
  {
    const RelaxingFoundation foundation(depth, RelaxationProblem().blocks);
    auto curves = slowCurves(body, *history.tool, kernel, foundation);
    curves.resize(1);
    const MatrixXd found = foundation.follow(history, offset, series, curves);
    std::copy(found.data(), found.data() + found.rows(), forces.begin());
  }
  return forces;
}
} // namespace palpate
