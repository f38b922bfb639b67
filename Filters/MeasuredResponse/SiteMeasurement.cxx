// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredResponse/SiteMeasurement.h"

#include "Response/FilterThreads.h"
#include "Contact/ResponseContract.h"
#include "Contact/TriangleTree.h"
#include "MeasuredResponse/MeasuredRelaxation.h"

#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace palpate
{
double SiteMeasurement::place(double largestDistance)
{
  const FilterThreads threads;
  const BodyMesh& body = *this->Mesh;
  const PackedMesh packed(
    body.coordinates(), body.pointCount(), body.indices(), body.triangleCount());
  const TriangleTree tree(packed);
  double squares = 0.0;
  for (PlacedSite& site : this->Sites)
  {
    const SurfacePoint found = tree.closest(site.position);
    SiteAnchor anchor;
    site.distance = std::numeric_limits<double>::infinity();
    if (found.triangle >= 0)
    {
      anchor.triangle = packed.inputTriangle(found.triangle);
      anchor.point = found.projection.point;
      for (std::size_t k = 0; k < 3; ++k)
      {
        anchor.normal += found.projection.weights[static_cast<Eigen::Index>(k)] *
          body.pointNormal(packed.inputPoint(packed.corners(found.triangle)[k]));
      }
      anchor.normal.normalize();
      site.distance = std::sqrt(found.projection.squaredDistance);
    }
    this->Anchors.push_back(anchor);
    squares += site.distance * site.distance;
    if (site.distance > largestDistance)
    {
      std::ostringstream text;
      text << "lies " << site.distance << " mm from the surface, more than Maximum Site Distance, "
           << largestDistance << " mm";
      site.measured.refusal = text.str();
    }
  }
  return std::sqrt(squares / static_cast<double>(this->Sites.size()));
}

std::size_t SiteMeasurement::countRefused(std::string& reasons) const
{
  std::size_t count = 0;
  for (const PlacedSite& site : this->Sites)
  {
    if (!site.measured.refusal.empty())
    {
      reasons +=
        (count == 0 ? "site '" : "; site '") + site.measured.name + "': " + site.measured.refusal;
      ++count;
    }
  }
  return count;
}

int SiteMeasurement::modelParts() const
{
  int parts = 0;
  for (const IdentifiedBody* body : this->Used)
  {
    parts |= body->body.model == BodyModel::Layer ? LayerPart : HalfSpacePart;
    parts |= body->body.model == BodyModel::GlobalCompliance ? GlobalCompliancePart : 0;
  }
  return parts;
}

std::string SiteMeasurement::describe() const
{
  std::set<std::string> models;
  for (const IdentifiedBody* body : this->Used)
  {
    models.insert(nameOf(body->body.model));
  }
  std::string text;
  for (const std::string& model : models)
  {
    text += (text.empty() ? "" : " or ") + model;
  }
  std::string tools;
  std::string made;
  for (const MeasuredCurves& file : this->Files)
  {
    tools += (tools.empty() ? "" : " ") + file.toolText;
    if (!file.synthetic.empty() && made.find(file.synthetic) == std::string::npos)
    {
      made += (made.empty() ? "; synthetic: " : ", ") + file.synthetic;
    }
  }
  return text + siteRelaxationInWords(*this) + ", identified from " +
    (made.empty() ? "measured" : "synthetic") + " curves of " + tools + " at " +
    std::to_string(this->Used.size()) + (this->Used.size() == 1 ? " site" : " sites") + made;
}
} // namespace palpate
