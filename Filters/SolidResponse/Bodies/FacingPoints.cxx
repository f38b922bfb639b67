// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/FacingPoints.h"

#include "Response/BodyConversion.h"

#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
constexpr std::size_t PointsPerValue = 6; ///< number of points from which a value is interpolated
constexpr int FirstSearch = 24;           ///< number of nearest points in the first search
constexpr int WiderSearch = 8;            ///< factor on FirstSearch for the second search
constexpr std::size_t PointsOfPlane = 3;  ///< number of points that determine a plane
constexpr double LargestTurn = 0.5;       ///< cos 60°, for the largest angle between normals
} // namespace

FacingPoints::FacingPoints(vtkPolyData* surface, const std::function<bool(vtkIdType)>& isTaken)
  : Cloud(vtkSmartPointer<vtkPolyData>::New())
  , Locator(vtkSmartPointer<vtkStaticPointLocator>::New())
{
  const BodyMesh mesh = makeBodyMesh(surface);
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    if (isTaken(i))
    {
      points->InsertNextPoint(surface->GetPoint(i));
      this->Ids.push_back(i);
      this->Normals.push_back(mesh.pointNormal(static_cast<std::int32_t>(i)));
    }
  }
  this->Cloud->SetPoints(points);
  if (!this->isEmpty())
  {
    this->Locator->SetDataSet(this->Cloud);
    this->Locator->BuildLocator();
  }
}

/// Searches for suitable points among the `search` nearest points.
FacingPoints::Weights FacingPoints::find(int search, const double place[3], const Vector3& normal,
  const std::function<bool(vtkIdType)>& isWanted) const
{
  Weights found;
  vtkNew<vtkIdList> nearest;
  double sum = 0.0;
  this->Locator->FindClosestNPoints(search, place, nearest);
  for (vtkIdType k = 0; k < nearest->GetNumberOfIds() && found.size() < PointsPerValue; ++k)
  {
    const auto index = static_cast<std::size_t>(nearest->GetId(k));
    if (this->Normals[index].dot(normal) >= LargestTurn &&
      (!isWanted || isWanted(this->Ids[index])))
    {
      std::array<double, 3> at{};
      this->Cloud->GetPoint(nearest->GetId(k), at.data());
      found.emplace_back(
        this->Ids[index], 1.0 / std::max(vtkMath::Distance2BetweenPoints(at.data(), place), 1e-12));
      sum += found.back().second;
    }
  }
  for (auto& [id, weight] : found)
  {
    weight /= sum;
  }
  return found;
}

std::vector<std::pair<vtkIdType, double>> FacingPoints::around(
  const double place[3], const Vector3& normal) const
{
  const auto all = static_cast<int>(this->Ids.size());
  Weights found;
  for (int search = std::min(FirstSearch, all); search > 0 && found.size() < PointsPerValue;
       search = search < all ? std::min(WiderSearch * search, all) : 0)
  {
    found = this->find(search, place, normal, {});
  }
  return found;
}

std::vector<std::pair<vtkIdType, double>> FacingPoints::nearBy(const double place[3],
  const Vector3& normal, const std::function<bool(vtkIdType)>& isWanted) const
{
  const auto all = static_cast<int>(this->Ids.size());
  if (all == 0)
  {
    return {};
  }
  Weights found = this->find(std::min(FirstSearch, all), place, normal, isWanted);
  return found.size() >= PointsOfPlane
    ? found
    : this->find(std::min(WiderSearch * FirstSearch, all), place, normal, isWanted);
}
} // namespace palpate
