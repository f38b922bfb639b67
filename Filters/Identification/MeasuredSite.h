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

/// All curves measured at one place, and the result.
struct MeasuredSite
{
  std::string name;
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< mm
  std::vector<SiteCurve> curves;
  /// Why the site cannot be used; empty if it can.
  std::string refusal;
  IdentifiedBody body;
};

/// Collects the curves of the same sites from several files, each of one tool, in the order of
/// their appearance. An error names the site that two files put at different places.
PALPATE_EXPORT std::string collectSites(
  const std::vector<MeasuredCurves>& files, std::vector<MeasuredSite>& sites);

/// Prepares the curves of the site and identifies its body; sets `refusal` where that fails. A site
/// that shows a loop, a hold or an effect of speed beyond the limits is identified as one that
/// relaxes (RelaxingIdentification.h), if all its curves have times; so is every one with times if
/// the identification is given a relaxation.
PALPATE_EXPORT void identifySite(
  const ElasticityLimits& limits, const BodyIdentification& identification, MeasuredSite& site);
} // namespace palpate

#endif
