// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/FitReport.h"

#include "Identification/FitVerdict.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>

namespace palpate
{
double intervalWidth(const BodyFit& fit, bool isNoiseGiven, const IdentifiedBody& found)
{
  if (isNoiseGiven && found.withinNoise)
  {
    return Normal95 * found.noise;
  }
  const double least = FitLimits::LeastNoise * found.largestForce;
  return studentQuantile(fit.degreesOfFreedom) * std::max(found.misfit, least);
}

std::string noBody(const std::string& model)
{
  return "no " + model + " comes near the readings";
}

Eigen::Index reportBody(const BodyFit& fit, double width, bool findContact, IdentifiedBody& found)
{
  Eigen::Index next = 0;
  const auto error = [&] { return width * fit.errorPerNoise[next++]; };
  found.body = fit.body;
  found.spread = width * fit.spreadPerNoise;
  found.reducedModulus = logarithmicEstimate(fit.body.reducedModulus, error());
  if (fit.body.model == BodyModel::GlobalCompliance)
  {
    found.compliance = linearEstimate(fit.body.compliance, error());
  }
  else if (fit.body.model == BodyModel::Layer)
  {
    found.thickness = logarithmicEstimate(fit.body.thickness, error());
  }
  for (const double offset : fit.contactOffset)
  {
    found.contactOffset.push_back(
      findContact ? linearEstimate(offset, error()) : linearEstimate(0.0, 0.0));
  }
  return next;
}

void reportEnd(const AxisymmetricTool& tool, const std::shared_ptr<const LayerKernel>& kernel,
  double depth, IdentifiedBody& found)
{
  const SeriesPoint end = bodyResponse(found.body, tool, kernel, depth);
  found.endForce = std::max(found.endForce, end.force);
  found.endStiffness = std::max(found.endStiffness, end.stiffness);
  const IndentationPoint contact = localContact(found.body, tool, kernel, end.localDeflection);
  if (contact.contactRadius > found.end.contactRadius)
  {
    found.end = contact;
    found.endDepth = end.localDeflection;
  }
}
} // namespace palpate
