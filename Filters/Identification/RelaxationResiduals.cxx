// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/RelaxationResiduals.h"

#include "Identification/TrialLaw.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
// Step of ln p and ln τ for finite differences, whose error is 1e-6.
constexpr double LogStep = 1e-6;
// Step of the offset for finite differences, as a fraction of the depth.
constexpr double OffsetStep = 1e-5;
constexpr double LargestLog = 25.0;  // largest magnitude of ln p
constexpr double LargestTime = 40.0; // largest magnitude of ln τ, with τ in s

bool isUsable(const PronySeries& series)
{
  bool usable = true;
  for (std::size_t i = 0; i < series.count; ++i)
  {
    const double strength = std::log(series.strength[i]);
    usable = usable && (series.strength[i] == 0.0 || std::abs(strength) < LargestLog) &&
      std::abs(std::log(series.time[i])) < LargestTime;
  }
  return usable;
}
} // namespace

std::vector<RelaxingFoundation::SlowCurve> slowCurves(const BodyParameters& body,
  const AxisymmetricTool& tool, const std::shared_ptr<const LayerKernel>& kernel,
  const RelaxingFoundation& foundation)
{
  const VectorXd& depths = foundation.depths();
  const TrialLaw law(body, tool, kernel);
  const Index count = depths.size();
  const bool hasSecond = body.model != BodyModel::HalfSpace;
  std::vector<RelaxingFoundation::SlowCurve> curves(hasSecond ? 3 : 2);
  for (RelaxingFoundation::SlowCurve& curve : curves)
  {
    curve.force = VectorXd::Zero(count);
  }
  curves[0].stiffness = VectorXd::Zero(count);
  // Any finite value, because the stiffness at 0 is not used.
  curves[0].stiffness[0] = law.at(1e-3 * depths[1]).stiffness;
  for (Index j = 1; j < count; ++j)
  {
    const Sensitivity at = law.at(depths[j]);
    curves[0].force[j] = at.force;
    curves[0].stiffness[j] = at.stiffness;
    curves[1].force[j] = at.byLogModulus;
    if (hasSecond)
    {
      curves[2].force[j] = at.bySecond;
    }
  }
  return curves;
}

namespace
{
std::vector<FirstContact> startsOf(const std::vector<PressHistory>& histories)
{
  std::vector<FirstContact> starts;
  for (const PressHistory& history : histories)
  {
    starts.push_back(history.loading.start);
  }
  return starts;
}
} // namespace

RelaxationResiduals::RelaxationResiduals(
  const std::vector<PressHistory>& histories, const RelaxationProblem& problem)
  : PackedBody(problem.model, problem.findContact, startsOf(histories))
  , Histories(histories)
  , Problem(problem)
{
  for (const PressHistory& history : histories)
  {
    for (std::size_t i = 0; i < history.size(); ++i)
    {
      this->Count += history.readings[i] > 0.0 ? 1 : 0;
      this->Force = std::max(this->Force, history.readings[i] > 0.0 ? history.netForce(i) : 0.0);
    }
    const auto [low, high] =
      std::minmax_element(history.deflection.begin(), history.deflection.end());
    this->Depth = std::max(this->Depth, *high - *low);
  }
}

VectorXd RelaxationResiduals::pack(const RelaxingBody& body) const
{
  VectorXd p(this->inputs());
  this->packBody(body.body, body.contactOffset, body.baseline, p);
  for (Index i = 0; i < this->branches(); ++i)
  {
    const auto branch = static_cast<std::size_t>(i);
    p[this->firstStrength() + i] = std::log(body.series.strength[branch]);
    p[this->firstStrength() + this->branches() + i] = std::log(body.series.time[branch]);
  }
  return p;
}

RelaxingBody RelaxationResiduals::unpack(const VectorXd& p) const
{
  RelaxingBody body;
  body.body = this->PackedBody::body(p);
  for (std::size_t c = 0; c < this->Histories.size(); ++c)
  {
    body.contactOffset.push_back(this->offset(p, c));
    body.baseline.push_back(this->baseline(p, c));
  }
  body.series = this->Problem.given;
  if (this->Problem.branches > 0)
  {
    body.series = {};
    for (Index i = 0; i < this->branches(); ++i)
    {
      body.series.add(std::exp(p[this->firstStrength() + i]),
        std::exp(p[this->firstStrength() + this->branches() + i]));
    }
  }
  return body;
}

int RelaxationResiduals::evaluate(const VectorXd& p, VectorXd* residuals, MatrixXd* jacobian) const
{
  if (jacobian)
  {
    jacobian->setZero();
  }
  const RelaxingBody trial = this->unpack(p);
  if (!p.allFinite() || !PackedBody::isUsable(trial.body) || !palpate::isUsable(trial.series))
  {
    if (residuals)
    {
      residuals->setConstant(Astray);
    }
    return 0;
  }
  Index row = 0;
  for (std::size_t c = 0; c < this->Histories.size(); ++c)
  {
    this->fillRows(trial, c, row, residuals, jacobian);
    row += std::count_if(this->Histories[c].readings.begin(), this->Histories[c].readings.end(),
      [](double readings) { return readings > 0.0; });
  }
  return 0;
}

/// Fills the rows of one history, starting at `row`.
void RelaxationResiduals::fillRows(const RelaxingBody& trial, std::size_t index, Index row,
  VectorXd* residuals, MatrixXd* jacobian) const
{
  const PressHistory& history = this->Histories[index];
  const double offset = trial.contactOffset[index];
  const ForceBaseline& baseline = trial.baseline[index];
  const double depth =
    *std::max_element(history.deflection.begin(), history.deflection.end()) - offset;
  const auto scatter = [&](const auto& values, auto&& target)
  {
    Index next = row;
    for (std::size_t i = 0; i < history.size(); ++i)
    {
      if (history.readings[i] > 0.0)
      {
        target(next++, i, values(static_cast<Index>(i)));
      }
    }
  };
  const auto weight = [&](std::size_t i) { return std::sqrt(history.readings[i]) / this->Force; };
  const auto setResidual = [&](Index at, std::size_t i, double force)
  {
    const double left = force + baseline.at(history.deflection[i]) - history.force[i];
    (*residuals)[at] = std::isfinite(force) ? weight(i) * left : Astray;
  };
  if (jacobian)
  {
    Index next = row;
    for (std::size_t i = 0; i < history.size(); ++i)
    {
      if (history.readings[i] > 0.0)
      {
        this->fillBaseline(*jacobian, next++, index, history.deflection[i], history.readings[i]);
      }
    }
  }
  if (!(depth > 0.0)) // there is no contact
  {
    if (residuals)
    {
      scatter(VectorXd::Zero(static_cast<Index>(history.size())), setResidual);
    }
    return;
  }
  const RelaxingFoundation foundation(depth, this->Problem.blocks);
  std::vector<RelaxingFoundation::SlowCurve> curves =
    slowCurves(trial.body, *history.tool, this->Problem.kernel, foundation);
  if (!jacobian)
  {
    curves.resize(1);
  }
  const MatrixXd forces = foundation.follow(history, offset, trial.series, curves);
  if (residuals)
  {
    scatter(forces.col(0), setResidual);
  }
  if (!jacobian)
  {
    return;
  }
  const auto fill = [&](Index column, const VectorXd& derivative)
  {
    scatter(derivative,
      [&](Index at, std::size_t i, double value)
      { (*jacobian)(at, column) = std::isfinite(value) ? weight(i) * value : 0.0; });
  };
  fill(0, forces.col(1));
  if (this->materialCount() > 1)
  {
    fill(1, forces.col(2) * this->secondScale());
  }
  curves.resize(1);
  if (this->Offsets > 0)
  {
    const double step = OffsetStep * depth;
    const auto moved = [&](double by)
    { return foundation.follow(history, offset + by, trial.series, curves); };
    fill(this->materialCount() + static_cast<Index>(index),
      (moved(step) - moved(-step)).col(0) * (this->Depth / (2.0 * step)));
  }
  for (Index i = 0; i < 2 * this->branches(); ++i)
  {
    PronySeries series = trial.series;
    const auto branch = static_cast<std::size_t>(i % this->branches());
    (i < this->branches() ? series.strength : series.time)[branch] *= std::exp(LogStep);
    fill(this->firstStrength() + i,
      (foundation.follow(history, offset, series, curves) - forces.leftCols(1)).col(0) / LogStep);
  }
}
} // namespace palpate
