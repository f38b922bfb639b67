// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/ComplianceError.h"

#include "Solids/FiniteElements/EnergyError.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/SharedWork.h"
#include "Solids/TrueShape/ElementError.h"
#include "Solids/TrueShape/SourceThinning.h"
#include "Solids/TrueShape/SubtractedLoad.h"
#include "Solids/TrueShape/SurfaceDisc.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double SampleCount = 10.0; ///< approximate number of sample points
/// Number of sources whose displacement fields are in memory at the same time.
constexpr std::size_t SourcesPerBatch = 4;
constexpr double DifferenceFactor = 2.0;

/// Returns about SampleCount points that have a compliance, spread over the surface.
std::vector<std::int32_t> samplePoints(const ElasticBody& body, const PatchCompliances& compliances)
{
  const BodySurface& surface = body.surface();
  std::vector<std::int32_t> candidates;
  // The area is summed over the triangles around the candidates. Each triangle counts at its three
  // corners.
  double area = 0.0;
  for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
  {
    if (compliances.status[static_cast<std::size_t>(i)] == PatchStatus::Valid &&
      isOfOneMaterial(body, i))
    {
      candidates.push_back(i);
      for (const std::int32_t* t = surface.trianglesBegin(i); t != surface.trianglesEnd(i); ++t)
      {
        area += surface.triangleArea(*t) / 3.0;
      }
    }
  }
  return thinnedSources(
    surface, candidates, std::vector<double>(candidates.size(), std::sqrt(area / SampleCount)));
}
} // namespace

std::vector<double> complianceErrors(
  const ElasticBody& body, const PatchCompliances& compliances, const WorkObserver& observer)
{
  const BodySurface& surface = body.surface();
  const std::vector<std::int32_t> samples = samplePoints(body, compliances);
  std::vector<double> atSamples(samples.size(), NotANumber);
  const SubtractedLoad loads(body);
  const auto estimate = [&](std::size_t block)
  {
    const std::size_t first = block * SourcesPerBatch;
    const std::size_t last = std::min(samples.size(), first + SourcesPerBatch);
    Eigen::MatrixXd right(body.unknowns(), static_cast<Eigen::Index>(last - first));
    for (std::size_t s = first; s < last; ++s)
    {
      right.col(static_cast<Eigen::Index>(s - first)) =
        loads.load(SingularSource(body, samples[s]));
    }
    const Eigen::MatrixXd smooth = body.factor().solveAll(right);
    if (smooth.size() == 0)
    {
      return; // there is not enough memory for an estimate of the error
    }
    std::vector<Eigen::Matrix3Xd> moved;
    for (std::size_t s = first; s < last; ++s)
    {
      moved.push_back(regularDisplacement(
        body, SingularSource(body, samples[s]), smooth.col(static_cast<Eigen::Index>(s - first))));
    }
    const std::vector<double> energies = energyErrors(body, moved);
    for (std::size_t s = first; s < last; ++s)
    {
      const std::int32_t point = samples[s];
      const double otherWay = -surface.normal(point).dot(moved[s - first].col(surface.node(point)));
      atSamples[s] = DifferenceFactor *
          std::abs(otherWay - compliances.compliance[static_cast<std::size_t>(point)]) +
        BoundOfEnergy * energies[s - first];
    }
  };
  if (!shareWork((samples.size() + SourcesPerBatch - 1) / SourcesPerBatch, estimate, observer))
  {
    return {};
  }
  // Between the samples, the error is proportional to the prediction of ElementError.
  const ElementError expected(body);
  const auto expectedAt = [&](std::int32_t point)
  { return expected.at(SingularSource(body, point)).error; };
  for (std::size_t s = 0; s < samples.size(); ++s)
  {
    atSamples[s] /= expectedAt(samples[s]);
  }
  std::vector<double> errors(static_cast<std::size_t>(surface.pointTotal()));
  const auto carry = [&](std::size_t i)
  {
    const auto point = static_cast<std::int32_t>(i);
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t s = 0; s < samples.size(); ++s)
    {
      const double square = (surface.position(samples[s]) - surface.position(point)).squaredNorm();
      const double weight = 1.0 / std::max(square, 1e-300);
      sum += weight * atSamples[s];
      weights += weight;
    }
    errors[i] = weights > 0.0 ? expectedAt(point) * sum / weights : NotANumber;
  };
  shareWork(errors.size(), carry);
  return errors;
}
} // namespace palpate
