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
  /// The reason why the site cannot be used; empty if it can be used.
  std::string refusal;
  IdentifiedBody body;
};

/// Collects the curves of each site from several files, in the order in which they occur. Each file
/// has the curves of one tool. Returns an error message if a site has different positions in two
/// files, else "".
PALPATE_EXPORT std::string collectSites(
  const std::vector<MeasuredCurves>& files, std::vector<MeasuredSite>& sites);

/// Prepares the curves of the site and identifies its body. Sets `refusal` on failure. A relaxing
/// body is identified (RelaxingIdentification.h) if a loop, a hold or an effect of speed exceeds
/// the limits, and all curves have times. If the options contain the relaxation, a relaxing body is
/// assumed at every site with times.
PALPATE_EXPORT void identifySite(
  const ElasticityLimits& limits, const BodyIdentification& identification, MeasuredSite& site);
} // namespace palpate

#endif
