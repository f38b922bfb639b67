// SPDX-License-Identifier: BSD-3-Clause
#include "FacingPoints.h"

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
constexpr std::size_t Wanted = 6;   ///< points a value is taken from
constexpr int FirstSearch = 24;     ///< nearest points looked through for them, at first
constexpr double LargestTurn = 0.5; ///< cos 60°
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

std::vector<std::pair<vtkIdType, double>> FacingPoints::around(
  const double place[3], const Vector3& normal) const
{
  const auto all = static_cast<int>(this->Ids.size());
  std::vector<std::pair<vtkIdType, double>> found;
  vtkNew<vtkIdList> nearest;
  for (int search = std::min(FirstSearch, all); search > 0; search = std::min(8 * search, all))
  {
    found.clear();
    double sum = 0.0;
    this->Locator->FindClosestNPoints(search, place, nearest);
    for (vtkIdType k = 0; k < nearest->GetNumberOfIds() && found.size() < Wanted; ++k)
    {
      const auto index = static_cast<std::size_t>(nearest->GetId(k));
      if (this->Normals[index].dot(normal) >= LargestTurn)
      {
        std::array<double, 3> at{};
        this->Cloud->GetPoint(nearest->GetId(k), at.data());
        found.emplace_back(this->Ids[index],
          1.0 / std::max(vtkMath::Distance2BetweenPoints(at.data(), place), 1e-12));
        sum += found.back().second;
      }
    }
    if (found.size() == Wanted || search == all)
    {
      for (auto& [id, weight] : found)
      {
        weight /= sum;
      }
      break;
    }
  }
  return found;
}
} // namespace palpate
