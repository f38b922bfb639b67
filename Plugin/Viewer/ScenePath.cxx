// SPDX-License-Identifier: BSD-3-Clause
#include "ScenePath.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPressPath.h"

#include <algorithm>

namespace palpate
{
std::string makePath(const ViewerScene& scene, vtkPolyData* path)
{
  vtkNew<vtkPressPath> press;
  press->SetInputData(scene.body);
  press->SetCenter(scene.center[0], scene.center[1], scene.center[2]);
  for (const Direction& direction : scene.directions)
  {
    press->AddDirection(direction[0], direction[1], direction[2]);
  }
  press->SetDepth(scene.depth);
  const std::string error = updateQuietly(press);
  path->ShallowCopy(press->GetOutput());
  return error;
}

std::array<double, 3> TouchSite::above(double height) const
{
  std::array<double, 3> place{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    place[k] = this->point[k] + height * this->normal[k];
  }
  return place;
}

namespace
{
TouchSite siteAt(vtkPolyData* bodyWithResponse, vtkIdType point)
{
  TouchSite site;
  bodyWithResponse->GetPoint(point, site.point.data());
  bodyWithResponse->GetPointData()->GetArray("ResponseNormal")->GetTuple(point, site.normal.data());
  return site;
}
} // namespace

TouchSite firstSite(const ViewerScene& scene, vtkPolyData* bodyWithResponse)
{
  constexpr double cosine = 0.9994;
  const Direction& direction = scene.directions.front();
  const double length = vtkMath::Norm(direction.data());
  vtkIdType best = 0;
  double farthest = 0.0;
  for (vtkIdType i = 0; i < bodyWithResponse->GetNumberOfPoints(); ++i)
  {
    double point[3];
    bodyWithResponse->GetPoint(i, point);
    vtkMath::Subtract(point, scene.center.data(), point);
    const double along = vtkMath::Dot(point, direction.data()) / length;
    if (along > farthest && along > cosine * vtkMath::Norm(point))
    {
      farthest = along;
      best = i;
    }
  }
  return siteAt(bodyWithResponse, best);
}

PictureAxes::PictureAxes(const ViewerScene& scene)
{
  double towards[3] = { scene.viewFrom[0], scene.viewFrom[1], scene.viewFrom[2] };
  vtkMath::Normalize(towards);
  vtkMath::Cross(scene.up.data(), towards, this->right);
  vtkMath::Normalize(this->right);
  vtkMath::Cross(towards, this->right, this->up);
}

TouchSite siteOfHand(const ViewerScene& scene, vtkPolyData* bodyWithResponse, int hand)
{
  // Distance between sites, mm; about the distance between two fingers.
  constexpr double step = 15.0;
  // Upper limit of this distance, as a fraction of the body's diagonal.
  constexpr double share = 0.1;
  const TouchSite first = firstSite(scene, bodyWithResponse);
  if (hand == 0)
  {
    return first;
  }
  const double way = hand * std::min(step, share * bodyWithResponse->GetLength());
  const PictureAxes axes(scene);
  double place[3];
  for (int k = 0; k < 3; ++k)
  {
    place[k] = first.point[static_cast<std::size_t>(k)] + way * axes.right[k];
  }
  return siteAt(bodyWithResponse, bodyWithResponse->FindPoint(place));
}
} // namespace palpate
