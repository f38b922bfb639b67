// SPDX-License-Identifier: BSD-3-Clause
#ifndef DataError_h
#define DataError_h

#include "Laws/LocalContact.h"
#include "MeasuredResponse/SiteMeasurement.h"

#include <cstddef>
#include <vector>

namespace palpate
{
class AxisymmetricTool;

/**
 * The error of a tool's force on a measured body, at each sample of its response. It is the sum of
 * two parts: the uncertainty at the sites (predictedForceError), interpolated like the material,
 * and the weighted root mean square deviation of ln F of the sites from the interpolated value. At
 * a site the error is that of the site; between sites it grows with their disagreement. Differences
 * of the body that were not measured at any site are not included.
 *
 * Cost: five evaluations of the body per site and sample; then a sum over the sites of a point.
 */
class DataError
{
public:
  /// For a response with `samples` samples down to `range` (mm). `measurement` must be complete,
  /// with its Spread, and must outlive this object.
  DataError(
    const SiteMeasurement& measurement, const AxisymmetricTool& tool, double range, int samples);

  /// Relative error at a sample 0 … n-1 of a point, which must be within the reach of a site.
  double at(std::size_t point, std::size_t sample) const;
  /// The deepest measured contact, interpolated, for E* = 1. The point must be within the reach of
  /// a site.
  LocalState contactAt(std::size_t point) const;

private:
  const SiteMeasurement& Measurement;
  std::vector<std::vector<double>> Open;      ///< for each sample, each site
  std::vector<std::vector<double>> LogForces; ///< for each sample, each site; ln F
  std::vector<double> Depths;                 ///< deepest contact of each site, mm
  std::vector<double> Radii;                  ///< mm
  std::vector<double> Forces;                 ///< F/E*, mm²
  std::vector<double> Stiffnesses;            ///< (dF/dδ)/E*, mm
};
} // namespace palpate

#endif
