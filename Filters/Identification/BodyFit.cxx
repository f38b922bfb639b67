// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/BodyFit.h"

#include "Identification/FitResiduals.h"
#include "Identification/LeastSquares.h"
#include "Mechanics/Layers/LayerContact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace palpate
{
namespace
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int OffsetCandidates = 41;
constexpr std::size_t FewReadings = 16;

/// The offset and E* of a half-space nearest to a curve, from a scan; E* by linear least squares.
double scanOffset(const IndentationCurve& curve)
{
  const double first = curve.deflection.front();
  const double range = curve.deflection.back() - first;
  double best = first;
  double bestSquares = std::numeric_limits<double>::infinity();
  for (int k = 0; k < OffsetCandidates; ++k)
  {
    const double offset = first + range * (1.4 * k / (OffsetCandidates - 1) - 0.5);
    double products = 0.0;
    double squares = 0.0;
    double total = 0.0;
    for (std::size_t i = 0; i < curve.force.size(); ++i)
    {
      const double unit = curve.tool->force(curve.deflection[i] - offset, 1.0);
      products += unit * curve.force[i];
      squares += unit * unit;
      total += curve.force[i] * curve.force[i];
    }
    const double left = squares > 0.0 ? total - products * products / squares : total;
    if (left < bestSquares)
    {
      bestSquares = left;
      best = offset;
    }
  }
  return best;
}

/// E* that matches the deepest reading of the first curve, with the other parameters given.
double matchModulus(BodyParameters body, const IndentationCurve& curve, double offset,
  const std::shared_ptr<const LayerKernel>& kernel)
{
  body.reducedModulus = 1.0;
  const double force = curve.force.back();
  const double local = curve.deflection.back() - offset - body.compliance * force;
  body.model = body.model == BodyModel::Layer ? body.model : BodyModel::HalfSpace;
  body.compliance = 0.0;
  return force / bodyResponse(body, *curve.tool, kernel, local).force;
}

/// Start values: from a nearly local to a nearly global body, from a thick to a thin layer.
std::vector<BodyParameters> startingBodies(BodyModel model, const IndentationCurve& curve,
  double offset, const std::shared_ptr<const LayerKernel>& kernel)
{
  std::vector<BodyParameters> starts;
  const double depth = curve.deflection.back() - offset;
  const double radius = curve.tool->contactRadius(depth);
  for (const double share : { 0.1, 0.4, 0.8 })
  {
    BodyParameters body;
    body.model = model;
    if (model == BodyModel::GlobalCompliance)
    {
      body.compliance = share * depth / curve.force.back();
    }
    if (model == BodyModel::Layer)
    {
      body.thickness = radius / share;
    }
    body.reducedModulus = matchModulus(body, curve, offset, kernel);
    if (body.reducedModulus > 0.0 && std::isfinite(body.reducedModulus))
    {
      starts.push_back(body);
    }
    if (model == BodyModel::HalfSpace)
    {
      break;
    }
  }
  return starts;
}

/// Some of the readings, evenly, the deepest among them.
IndentationCurve thin(const IndentationCurve& curve)
{
  IndentationCurve few;
  few.tool = curve.tool;
  few.readings = curve.readings;
  const std::size_t step = (curve.force.size() + FewReadings - 1) / FewReadings;
  for (std::size_t i = (curve.force.size() - 1) % step; i < curve.force.size(); i += step)
  {
    few.deflection.push_back(curve.deflection[i]);
    few.force.push_back(curve.force[i]);
  }
  return few;
}
} // namespace

IndentationPoint localContact(const BodyParameters& body, const AxisymmetricTool& tool,
  const std::shared_ptr<const LayerKernel>& kernel, double deflection)
{
  return body.model == BodyModel::Layer
    ? LayerContact(tool, kernel, body.thickness).evaluate(deflection, body.reducedModulus)
    : tool.evaluate(deflection, body.reducedModulus);
}

SeriesPoint bodyResponse(const BodyParameters& body, const AxisymmetricTool& tool,
  const std::shared_ptr<const LayerKernel>& kernel, double deflection)
{
  if (body.model == BodyModel::Layer)
  {
    const IndentationPoint point = localContact(body, tool, kernel, deflection);
    return { point.force, point.stiffness, deflection, true };
  }
  return seriesResponse(tool, body.reducedModulus, body.compliance, deflection);
}

double BodyFit::residual() const
{
  return std::sqrt(this->sumOfSquares / std::max(1, this->degreesOfFreedom));
}

std::optional<BodyFit> fitBody(const std::vector<IndentationCurve>& curves, BodyModel model,
  bool findContact, const std::shared_ptr<const LayerKernel>& kernel)
{
  FitResiduals residuals(curves, model, findContact, kernel);
  BodyFit fit;
  fit.degreesOfFreedom = static_cast<int>(residuals.values() - residuals.inputs());
  if (fit.degreesOfFreedom < 1)
  {
    return std::nullopt;
  }
  std::vector<double> offsets;
  std::vector<IndentationCurve> few;
  for (const IndentationCurve& curve : curves)
  {
    offsets.push_back(findContact ? scanOffset(curve) : 0.0);
    few.push_back(thin(curve));
  }
  // Every start is fitted to few readings, the best result to all.
  FitResiduals coarse(few, model, findContact, kernel);
  VectorXd best;
  double least = std::numeric_limits<double>::infinity();
  for (const BodyParameters& start : startingBodies(model, curves.front(), offsets.front(), kernel))
  {
    VectorXd p = coarse.pack(start, offsets);
    const double squares = minimize(coarse, p, 1e-6).squares;
    if (squares < least && p.allFinite())
    {
      least = squares;
      best = p;
    }
  }
  if (best.size() == 0)
  {
    return std::nullopt;
  }
  best.tail(best.size() - residuals.materialCount()) *= coarse.depth() / residuals.depth();
  if (model == BodyModel::GlobalCompliance)
  {
    best[1] *= coarse.compliance() / residuals.compliance();
  }
  const Minimum minimum = minimize(residuals, best, 1e-11);
  if (!best.allFinite() || !PackedBody::isBody(minimum.squares))
  {
    return std::nullopt;
  }
  fit.sumOfSquares = minimum.squares * residuals.force() * residuals.force();
  fit.converged = minimum.converged;
  fit.body = residuals.body(best);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    fit.contactOffset.push_back(residuals.offset(best, i));
  }
  MatrixXd jacobian(residuals.values(), residuals.inputs());
  residuals.df(best, jacobian);
  residuals.judge(jacobian, fit);
  return fit;
}

double modulusErrorBesideCompliance(
  const std::vector<IndentationCurve>& curves, const BodyFit& halfSpace, bool findContact)
{
  const FitResiduals residuals(curves, BodyModel::GlobalCompliance, findContact, nullptr);
  MatrixXd jacobian(residuals.values(), residuals.inputs());
  residuals.df(residuals.pack(halfSpace.body, halfSpace.contactOffset), jacobian);
  return residuals.modulusError(jacobian);
}
} // namespace palpate
