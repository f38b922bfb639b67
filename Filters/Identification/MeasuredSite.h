// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeasuredSite_h
#define palpate_MeasuredSite_h

#include "Identification/BodyIdentification.h"
#include "Identification/CurvePreparation.h"
#include "Identification/MeasuredCurve.h"
#include "Mechanics/PalpateExport.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// One tool's curve at a site.
struct SiteCurve
{
  std::string toolText;
  std::shared_ptr<const AxisymmetricTool> tool;
  MeasuredCurve curve;
  PreparedCurve prepared;
};

/// All curves measured at one site, and the result.
struct MeasuredSite
{
  std::string name;
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< mm
  std::vector<SiteCurve> curves;
  /// The reason why the site cannot be used; empty if it can.
  std::string refusal;
  IdentifiedBody body;
};

/// Collects the curves of each site from several files, each of one tool, in the order of their
/// appearance. An error names the site that two files put at different places.
PALPATE_EXPORT std::string collectSites(
  const std::vector<MeasuredCurves>& files, std::vector<MeasuredSite>& sites);

/// Prepares the curves of the site and identifies its body; sets `refusal` on failure. A site that
/// shows a loop, a hold or an effect of speed beyond the limits is identified as a relaxing one
/// (RelaxingIdentification.h), if all its curves have times. If the relaxation is given in the
/// options, every site with times is identified in this way.
PALPATE_EXPORT void identifySite(
  const ElasticityLimits& limits, const BodyIdentification& identification, MeasuredSite& site);
} // namespace palpate

#endif
