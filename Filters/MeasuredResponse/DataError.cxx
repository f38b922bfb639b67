// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredResponse/DataError.h"

#include "Contact/ResponseSampling.h"
#include "Identification/PredictedForceError.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

namespace palpate
{
DataError::DataError(
  const SiteMeasurement& measurement, const AxisymmetricTool& tool, double range, int samples)
  : Measurement(measurement)
{
  const ResponseSampling sampling(samples, 1.0); // the depths do not depend on the exponent
  const std::shared_ptr<const LayerKernel>& kernel = measurement.Identification->kernel();
  for (int i = 0; i < samples; ++i)
  {
    const double depth = sampling.depth(i, range);
    std::vector<double> open;
    std::vector<double> forces;
    for (const IdentifiedBody* site : measurement.Used)
    {
      open.push_back(predictedForceError(*site, tool, kernel, depth));
      const double force = bodyResponse(site->body, tool, kernel, depth).force;
      forces.push_back(std::log(force > 0.0 ? force
                                            // Without a force the relative error becomes large.
                                            : std::numeric_limits<double>::min()));
    }
    this->Open.push_back(std::move(open));
    this->LogForces.push_back(std::move(forces));
  }
  for (const IdentifiedBody* site : measurement.Used)
  {
    const double modulus = site->body.reducedModulus;
    this->Depths.push_back(site->endDepth);
    this->Radii.push_back(site->end.contactRadius);
    this->Forces.push_back(site->end.force / modulus);
    this->Stiffnesses.push_back(site->end.stiffness / modulus);
  }
}

double DataError::at(std::size_t point, std::size_t sample) const
{
  const auto place = static_cast<std::int32_t>(point);
  const SiteSpread& spread = *this->Measurement.Spread;
  return spread.at(place, this->Open[sample]) + spread.deviationAt(place, this->LogForces[sample]);
}

LocalState DataError::contactAt(std::size_t point) const
{
  const auto place = static_cast<std::int32_t>(point);
  const SiteSpread& spread = *this->Measurement.Spread;
  LocalState state;
  state.depth = spread.at(place, this->Depths);
  state.force = spread.at(place, this->Forces);
  state.stiffness = spread.at(place, this->Stiffnesses);
  state.radius = spread.at(place, this->Radii);
  return state;
}
} // namespace palpate
