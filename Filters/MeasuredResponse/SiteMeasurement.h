// SPDX-License-Identifier: BSD-3-Clause
#ifndef SiteMeasurement_h
#define SiteMeasurement_h

#include "Identification/BodyIdentification.h"
#include "Contact/BodyMesh.h"
#include "Identification/MeasuredCurve.h"
#include "MeasuredResponse/SiteSpread.h"
#include "MeasuredResponse/SiteTables.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// The state of vtkMeasuredContactResponse after its files are read and before its response is
/// computed.
struct SiteMeasurement
{
  std::vector<MeasuredCurves> Files;
  std::vector<PlacedSite> Sites;
  std::vector<SiteAnchor> Anchors; ///< projections of the sites on the mesh
  std::unique_ptr<BodyIdentification> Identification;
  std::unique_ptr<BodyMesh> Mesh;
  std::unique_ptr<SiteSpread> Spread; ///< interpolation between the sites used
  std::vector<const IdentifiedBody*> Used;

  std::vector<double> collect(double IdentifiedBody::*member) const
  {
    std::vector<double> values;
    for (const IdentifiedBody* body : this->Used)
    {
      values.push_back(body->*member);
    }
    return values;
  }

  /// Projects the sites on the mesh, and refuses sites whose distance from the mesh exceeds
  /// `largestDistance` (mm). Returns the root mean square of the distances, mm.
  double place(double largestDistance);

  /// Returns the number of refused sites. `reasons` receives their names and the reasons.
  std::size_t countRefused(std::string& reasons) const;

  /// Describes the identified bodies and their data in words, for the field array Model.
  std::string describe() const;
  int modelParts() const; ///< sum of ModelPart
};
} // namespace palpate

#endif
