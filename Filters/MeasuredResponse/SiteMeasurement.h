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
/// The state of vtkMeasuredContactResponse between the files it reads and the response it makes.
struct SiteMeasurement
{
  std::vector<MeasuredCurves> Files;
  std::vector<PlacedSite> Sites;
  std::vector<SiteAnchor> Anchors; ///< of every site
  std::unique_ptr<BodyIdentification> Identification;
  std::unique_ptr<BodyMesh> Mesh;
  std::unique_ptr<SiteSpread> Spread; ///< of the sites that are used
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

  /// Finds where the sites lie on the mesh, and refuses those farther from it than
  /// `largestDistance` (mm). Returns the root mean square of their distances.
  double place(double largestDistance);

  /// How many sites are refused, and their names and reasons.
  std::size_t countRefused(std::string& reasons) const;

  /// What was identified, and from which data, for the field array Model.
  std::string describe() const;
  int modelParts() const; ///< sum of ModelPart
};
} // namespace palpate

#endif
