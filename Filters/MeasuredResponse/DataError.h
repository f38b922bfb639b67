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
 * The error of a tool's force on a measured body: at each sample of its response the uncertainty at
 * the sites (predictedForceError), interpolated as the material is, and the weighted root mean
 * square by which the sites' own forces differ from their mean. On a site it is that of the site,
 * and it grows between sites that disagree. A change of the body that no site has measured is not
 * counted.
 *
 * Cost: five evaluations of the body per site and sample; then a sum over the sites of a point.
 */
class DataError
{
public:
  /// Of a response with `samples` samples down to `range` (mm). `measurement`, spread over its
  /// body, must outlive this.
  DataError(
    const SiteMeasurement& measurement, const AxisymmetricTool& tool, double range, int samples);

  /// Relative, at a point within reach of a site (0 elsewhere) and a sample 0 … n-1.
  double at(std::size_t point, std::size_t sample) const;
  /// The deepest contact that was measured, interpolated, for E* = 1; its radius is 0 where no site
  /// reaches.
  LocalState contactAt(std::size_t point) const;

private:
  const SiteMeasurement& Measurement;
  std::vector<std::vector<double>> Open;      ///< of each sample, of each site
  std::vector<std::vector<double>> LogForces; ///< likewise; ln F
  std::vector<double> Depths;                 ///< of the deepest contact of each site, mm
  std::vector<double> Radii;                  ///< mm
  std::vector<double> Forces;                 ///< F/E*, mm²
  std::vector<double> Stiffnesses;            ///< (dF/dδ)/E*, mm
};
} // namespace palpate

#endif
