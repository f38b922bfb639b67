// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/FitReport.h"

#include "Identification/FitVerdict.h"
#include "Mechanics/Files/NumberText.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>

namespace palpate
{
double intervalWidth(const BodyFit& fit, bool isNoiseGiven, const IdentifiedBody& found)
{
  const double least = FitLimits::LeastError * found.largestForce;
  const double noise = std::max(found.noise, least);
  if (isNoiseGiven && leavesNoise(fit, { noise }))
  {
    return Normal95 * noise;
  }
  return studentQuantile(fit.degreesOfFreedom) * std::max(found.misfit, least);
}

std::string noBody(const std::string& model)
{
  return "no " + model + " fits the readings";
}

std::string tooFew(std::size_t readings, std::size_t of, double largestStrain)
{
  const std::string have = readings < of ? "the largest strain of " + shortly(largestStrain) +
      " leaves " + std::to_string(readings) + " of " + std::to_string(of)
                                         : "the loading has " + std::to_string(readings);
  return have + " readings; " + std::to_string(BodyIdentification::FewestReadings) + " are needed";
}

std::string leftOut(std::size_t readings, std::size_t of, double largestStrain)
{
  return readings == 0 ? std::string()
                       : std::to_string(readings) + " of " + std::to_string(of) +
      " readings are not used: they lie deeper than the largest strain of " +
      shortly(largestStrain) + " allows";
}

std::string undeterminedBaseline(const BodyFit& fit, bool findContact)
{
  const BaselineTerms least = findContact ? *std::min_element(fit.terms.begin(), fit.terms.end())
                                          : BaselineTerms::OffsetAndDrift;
  return least == BaselineTerms::None
    ? "too few readings precede contact: the offset of the force is taken as 0"
    : least == BaselineTerms::Offset
    ? "too few readings precede contact: the drift of the force is taken as 0"
    : "";
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
  for (std::size_t i = 0; i < fit.baseline.size(); ++i)
  {
    const auto terms = static_cast<int>(fit.terms[i]);
    found.baseline.push_back(fit.baseline[i]);
    found.forceOffset.push_back(linearEstimate(fit.baseline[i].offset, terms > 0 ? error() : 0.0));
    found.forceDrift.push_back(linearEstimate(fit.baseline[i].drift, terms > 1 ? error() : 0.0));
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
