// SPDX-License-Identifier: BSD-3-Clause
#include "ClearView.h"

#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"
#include "vtkStaticCellLocator.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
constexpr int Around = 12;        // number of directions at each angle from the preferred direction
constexpr double AngleStep = 7.5; // step between these angles, degrees
// Smallest angle between view and normal, degrees. At a smaller angle the tool would be seen nearly
// end-on.
constexpr double LeastAngle = 25.0;
constexpr double MostAngle = 75.0;   // largest angle between view and normal, degrees
constexpr double LeastFromUp = 20.0; // smallest angle between view and upward axis, degrees
// Height of Site::above over the surface, as a fraction of the body's diagonal.
constexpr double Raised = 0.005;

struct Site
{
  Eigen::Vector3d above; ///< a point slightly above the surface
  Eigen::Vector3d normal;
};

/// Returns the angle between two directions, degrees.
double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return vtkMath::DegreesFromRadians(std::atan2(a.cross(b).norm(), a.dot(b)));
}

class SightLines
{
public:
  explicit SightLines(const ViewerScene& scene)
    : Body(scene.body)
    , Length(scene.body->GetLength())
  {
    this->Locator->SetDataSet(scene.body);
    this->Locator->BuildLocator();
    const Eigen::Vector3d centre(scene.center.data());
    for (const Direction& each : scene.directions)
    {
      this->addSite(centre, Eigen::Vector3d(each.data()).normalized());
    }
  }

  const std::vector<Site>& sites() const { return this->Sites; }
  bool isClear(const Site& site, const Eigen::Vector3d& direction)
  {
    vtkIdType cell = -1;
    Eigen::Vector3d hit;
    return !this->hit(site.above, site.above + 2.0 * this->Length * direction, hit, cell);
  }

private:
  /// Adds the outermost point of the body in the direction `outward` from the centre as a site, if
  /// there is such a point.
  void addSite(const Eigen::Vector3d& centre, const Eigen::Vector3d& outward)
  {
    vtkIdType cell = -1;
    Eigen::Vector3d place;
    if (!this->hit(centre + 2.0 * this->Length * outward, centre, place, cell))
    {
      return;
    }
    vtkNew<vtkIdList> corners;
    this->Body->GetCellPoints(cell, corners);
    Eigen::Vector3d normal;
    vtkPolygon::ComputeNormal(this->Body->GetPoints(), static_cast<int>(corners->GetNumberOfIds()),
      corners->GetPointer(0), normal.data());
    normal *= normal.dot(outward) < 0.0 ? -1.0 : 1.0;
    this->Sites.push_back({ place + Raised * this->Length * normal, normal });
  }

  bool hit(
    const Eigen::Vector3d& from, const Eigen::Vector3d& to, Eigen::Vector3d& place, vtkIdType& cell)
  {
    double share = 0.0;
    double inside[3];
    int part = 0;
    return this->Locator->IntersectWithLine(
             from.data(), to.data(), 0.0, share, place.data(), inside, part, cell) != 0;
  }

  vtkPolyData* Body;
  double Length;
  vtkNew<vtkStaticCellLocator> Locator;
  std::vector<Site> Sites;
};

/// Returns directions, sorted by their angle from `wished`.
std::vector<Eigen::Vector3d> directionsFrom(const Eigen::Vector3d& wished)
{
  const Eigen::Vector3d side = wished.unitOrthogonal();
  std::vector<Eigen::Vector3d> directions{ wished };
  for (double angle = AngleStep; angle < 180.0; angle += AngleStep)
  {
    const Eigen::Vector3d tilted =
      Eigen::AngleAxisd(vtkMath::RadiansFromDegrees(angle), side) * wished;
    for (int i = 0; i < Around; ++i)
    {
      directions.emplace_back(Eigen::AngleAxisd(2.0 * vtkMath::Pi() * i / Around, wished) * tilted);
    }
  }
  return directions;
}
} // namespace

Direction clearView(const ViewerScene& scene)
{
  SightLines lines(scene);
  if (lines.sites().empty())
  {
    return scene.viewFrom;
  }
  const Eigen::Vector3d wished = Eigen::Vector3d(scene.viewFrom.data()).normalized();
  const Eigen::Vector3d up(scene.up.data());
  const std::vector<Site> first{ lines.sites().front() };
  struct Demand
  {
    const std::vector<Site>& sites;
    bool angles;
  };
  for (const Demand& demand :
    { Demand{ lines.sites(), true }, Demand{ first, true }, Demand{ first, false } })
  {
    for (const Eigen::Vector3d& direction : directionsFrom(wished))
    {
      const double fromUp = angleBetween(direction, up);
      const bool isUpright = fromUp > LeastFromUp && fromUp < 180.0 - LeastFromUp;
      const auto shows = [&](const Site& site)
      {
        const double angle = angleBetween(direction, site.normal);
        return (!demand.angles || (angle >= LeastAngle && angle <= MostAngle)) &&
          lines.isClear(site, direction);
      };
      if (isUpright && std::all_of(demand.sites.begin(), demand.sites.end(), shows))
      {
        return { direction.x(), direction.y(), direction.z() };
      }
    }
  }
  return scene.viewFrom;
}
} // namespace palpate
