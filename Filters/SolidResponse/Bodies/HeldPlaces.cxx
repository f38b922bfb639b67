// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/HeldPlaces.h"

#include "SolidResponse/Bodies/ClosestPlace.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkStaticPointLocator.h"

#include <Eigen/Geometry>

#include <array>
#include <utility>

namespace palpate
{
namespace
{
/// A corner with a smaller weight is ignored, because the weight is a rounding error.
constexpr double LeastShare = 1e-6;
} // namespace

HeldPlaces::HeldPlaces(vtkPolyData* surface, std::function<bool(vtkIdType)> isHeld)
  : Surface(surface)
  , Locator(vtkSmartPointer<vtkStaticCellLocator>::New())
  , Points(vtkSmartPointer<vtkStaticPointLocator>::New())
  , IsHeld(std::move(isHeld))
{
  surface->BuildCells(); // this must be done before several threads read the surface
  this->Locator->SetDataSet(surface);
  this->Locator->BuildLocator();
  this->Points->SetDataSet(surface);
  this->Points->BuildLocator();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    if (this->IsHeld(i))
    {
      this->Held.AddPoint(surface->GetPoint(i));
    }
  }
}

/// Returns whether a position is farther from the bounding box of the held points than from some
/// point of the surface. In this case it cannot be held. This quick check is sufficient for most
/// positions.
bool HeldPlaces::isFar(const Eigen::Vector3d& place) const
{
  if (!this->Held.IsValid())
  {
    return true;
  }
  const vtkIdType nearest = this->Points->FindClosestPoint(place.data());
  if (nearest < 0)
  {
    return true;
  }
  Eigen::Vector3d point;
  this->Surface->GetPoint(nearest, point.data());
  const Eigen::Vector3d low(this->Held.GetMinPoint());
  const Eigen::Vector3d high(this->Held.GetMaxPoint());
  return (place - place.cwiseMax(low).cwiseMin(high)).norm() > (place - point).norm();
}

bool HeldPlaces::contain(const double place[3]) const
{
  const Eigen::Vector3d from(place);
  if (!from.allFinite())
  {
    return false; // VTK finds no closest position for NaN or infinity
  }
  if (this->isFar(from))
  {
    return false;
  }
  const ClosestPlace closest = closestPlace(this->Locator, from);
  if (closest.cell < 0)
  {
    return false;
  }
  vtkNew<vtkIdList> corners;
  this->Surface->GetCellPoints(closest.cell, corners);
  std::array<Eigen::Vector3d, 3> away;
  for (std::size_t k = 0; k < 3; ++k)
  {
    this->Surface->GetPoint(corners->GetId(static_cast<vtkIdType>(k)), away[k].data());
    away[k] -= closest.at;
  }
  // The weight of a corner is the area of the triangle formed by the position and the other two
  // corners.
  const Eigen::Vector3d shares(
    away[1].cross(away[2]).norm(), away[2].cross(away[0]).norm(), away[0].cross(away[1]).norm());
  for (Eigen::Index k = 0; k < 3; ++k)
  {
    if (shares[k] >= LeastShare * shares.sum() && !this->IsHeld(corners->GetId(k)))
    {
      return false;
    }
  }
  return true;
}
} // namespace palpate
