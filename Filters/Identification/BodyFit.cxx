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

constexpr std::size_t FewReadings = 16;

/// Returns the force of the estimated half-space at the end of a curve. A single wrong reading has
/// little effect on this force.
double endForce(const IndentationCurve& curve)
{
  return curve.tool->force(curve.deflection.back() - curve.start.depth, curve.start.modulus);
}

/// Returns the E* for which the first curve has its end force. The other parameters are taken from
/// `body`.
double matchModulus(BodyParameters body, const IndentationCurve& curve,
  const std::shared_ptr<const LayerKernel>& kernel)
{
  body.reducedModulus = 1.0;
  const double force = endForce(curve);
  const double local = curve.deflection.back() - curve.start.depth - body.compliance * force;
  body.model = body.model == BodyModel::Layer ? body.model : BodyModel::HalfSpace;
  body.compliance = 0.0;
  return force / bodyResponse(body, *curve.tool, kernel, local).force;
}

/// Returns the initial bodies of the fit: from nearly local to nearly global deformation, or from a
/// thick to a thin layer.
std::vector<BodyParameters> startingBodies(
  BodyModel model, const IndentationCurve& curve, const std::shared_ptr<const LayerKernel>& kernel)
{
  std::vector<BodyParameters> starts;
  const double depth = curve.deflection.back() - curve.start.depth;
  const double radius = curve.tool->contactRadius(depth);
  for (const double share : { 0.1, 0.4, 0.8 })
  {
    BodyParameters body;
    body.model = model;
    if (model == BodyModel::GlobalCompliance)
    {
      body.compliance = share * depth / endForce(curve);
    }
    if (model == BodyModel::Layer)
    {
      body.thickness = radius / share;
    }
    body.reducedModulus = matchModulus(body, curve, kernel);
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

/// Returns an evenly spaced subset of the readings, including the deepest reading.
IndentationCurve thin(const IndentationCurve& curve)
{
  IndentationCurve few;
  few.tool = curve.tool;
  few.start = curve.start;
  const std::size_t step = (curve.force.size() + FewReadings - 1) / FewReadings;
  for (std::size_t i = (curve.force.size() - 1) % step; i < curve.force.size(); i += step)
  {
    few.append(curve.deflection[i], curve.force[i], curve.readings[i]);
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
  std::vector<ForceBaseline> baselines;
  std::vector<IndentationCurve> few;
  for (const IndentationCurve& curve : curves)
  {
    offsets.push_back(curve.start.depth);
    baselines.push_back(curve.start.baseline);
    few.push_back(thin(curve));
  }
  // Each initial body is fitted to a subset of the readings. Then the best result is fitted to all
  // readings.
  FitResiduals coarse(few, model, findContact, kernel);
  VectorXd best;
  double least = std::numeric_limits<double>::infinity();
  for (const BodyParameters& start : startingBodies(model, curves.front(), kernel))
  {
    VectorXd p = coarse.pack(start, offsets, baselines);
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
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    offsets[i] = coarse.offset(best, i);
    baselines[i] = coarse.baseline(best, i);
  }
  best = residuals.pack(coarse.body(best), offsets, baselines);
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
    fit.baseline.push_back(residuals.baseline(best, i));
    fit.terms.push_back(curves[i].start.terms);
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
  residuals.df(
    residuals.pack(halfSpace.body, halfSpace.contactOffset, halfSpace.baseline), jacobian);
  return residuals.modulusError(jacobian);
}
} // namespace palpate
