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
 * two parts. The first part is the uncertainty at the sites (predictedForceError), interpolated
 * like the material. The second part is the weighted root mean square deviation of ln F at the
 * sites from the interpolated value. At a site the error is that of the site; between sites it
 * increases with the differences between the sites. Variations of the body that are not measured at
 * any site are not included.
 *
 * Cost: five evaluations of the body per site and sample, and a sum over the nearby sites for each
 * point.
 */
class DataError
{
public:
  /// Computes the errors for a response with `samples` samples down to `range` (mm). `measurement`
  /// must be complete and have its Spread; it must outlive this object.
  DataError(
    const SiteMeasurement& measurement, const AxisymmetricTool& tool, double range, int samples);

  /// Returns the relative error at sample 0 … n-1 of a point. The point must be within the reach of
  /// a site.
  double at(std::size_t point, std::size_t sample) const;
  /// Returns the deepest measured contact, interpolated between the sites, for E* = 1. The point
  /// must be within the reach of a site.
  LocalState contactAt(std::size_t point) const;

private:
  const SiteMeasurement& Measurement;
  std::vector<std::vector<double>> Open;      ///< relative error for each sample and each site
  std::vector<std::vector<double>> LogForces; ///< ln F for each sample and each site
  std::vector<double> Depths;                 ///< deepest contact of each site, mm
  std::vector<double> Radii;       ///< contact radius of the deepest contact of each site, mm
  std::vector<double> Forces;      ///< F/E*, mm²
  std::vector<double> Stiffnesses; ///< (dF/dδ)/E*, mm
};
} // namespace palpate

#endif
