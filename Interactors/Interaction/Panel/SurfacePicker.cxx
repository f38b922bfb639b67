// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Panel/SurfacePicker.h"

#include "Contact/ResponseContract.h"

#include "vtkCamera.h"
#include "vtkCellLocator.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace palpate
{
namespace
{
/// Tolerance as a fraction of the body's diagonal. Without a tolerance, vtkStaticCellLocator misses
/// faces on the boundaries between its bins, such as the faces of a block.
constexpr double Tolerance = 1e-6;

/// Returns the point in world coordinates under a display position. `depth` is the depth in the
/// view volume, from 0 (near) to 1 (far).
void worldUnder(vtkRenderer* renderer, const int position[2], double depth, double world[3])
{
  renderer->SetDisplayPoint(position[0], position[1], depth);
  renderer->DisplayToWorld();
  double point[4];
  renderer->GetWorldPoint(point);
  for (int k = 0; k < 3; ++k)
  {
    world[k] = point[k] / point[3];
  }
}
} // namespace

SurfacePicker::SurfacePicker() = default;
SurfacePicker::~SurfacePicker() = default;

void SurfacePicker::setBody(vtkPolyData* body, const std::string& responseName)
{
  this->ResponseName = responseName;
  if (body == this->GivenBody)
  {
    return;
  }
  const bool isSameSurface = body && this->Body && body->GetPoints() == this->Body->GetPoints() &&
    body->GetPolys() == this->Body->GetPolys();
  this->GivenBody = body;
  if (isSameSurface)
  {
    this->Body->GetPointData()->ShallowCopy(body->GetPointData());
    return;
  }
  this->Locator = nullptr;
  this->Body = nullptr;
  if (body)
  {
    this->Body = vtkSmartPointer<vtkPolyData>::New();
    this->Body->ShallowCopy(body);
  }
}

bool SurfacePicker::pick(
  vtkRenderer* renderer, const int position[2], double point[3], double normal[3])
{
  if (!renderer || !this->Body)
  {
    return false;
  }
  if (!this->Locator)
  {
    this->Locator = vtkSmartPointer<vtkCellLocator>::New();
    this->Locator->SetDataSet(this->Body);
    this->Locator->BuildLocator();
  }
  double nearPoint[3];
  double farPoint[3];
  worldUnder(renderer, position, 0.0, nearPoint);
  worldUnder(renderer, position, 1.0, farPoint);
  double t = 0.0;
  double parametric[3];
  int subId = 0;
  vtkIdType cellId = -1;
  vtkNew<vtkGenericCell> cell;
  if (!this->Locator->IntersectWithLine(nearPoint, farPoint, Tolerance * this->Body->GetLength(), t,
        point, parametric, subId, cellId, cell))
  {
    return false;
  }
  vtkDataArray* normals = this->Body->GetPointData()->GetArray(
    palpate::arrayName(this->ResponseName, palpate::ResponseArray::Normal).c_str());
  const double weights[3] = { 1.0 - parametric[0] - parametric[1], parametric[0], parametric[1] };
  std::fill_n(normal, 3, 0.0);
  for (vtkIdType k = 0; normals && k < 3; ++k)
  {
    double corner[3];
    normals->GetTuple(cell->GetPointId(k), corner);
    for (int i = 0; i < 3; ++i)
    {
      normal[i] += weights[k] * corner[i];
    }
  }
  return vtkMath::Normalize(normal) > 0.0;
}

void pointInView(vtkRenderer* renderer, const int position[2], const double tip[3], double away,
  double point[3], double towards[3])
{
  double sight[3];
  double nearPoint[3];
  double farPoint[3];
  renderer->GetActiveCamera()->GetDirectionOfProjection(sight);
  worldUnder(renderer, position, 0.0, nearPoint);
  worldUnder(renderer, position, 1.0, farPoint);
  double whole[3];
  double toTip[3];
  vtkMath::Subtract(farPoint, nearPoint, whole);
  vtkMath::Subtract(tip, nearPoint, toTip);
  const double share = (vtkMath::Dot(toTip, sight) + away) / vtkMath::Dot(whole, sight);
  for (int k = 0; k < 3; ++k)
  {
    point[k] = nearPoint[k] + share * whole[k];
    towards[k] = -sight[k];
  }
}
} // namespace palpate
