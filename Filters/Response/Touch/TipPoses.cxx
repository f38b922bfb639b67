// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/TipPoses.h"

#include "Mechanics/JoinedText.h"
#include "Response/ArrayFetch.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace palpate
{
bool haveAxes(vtkPolyData* tips)
{
  return tips->GetPointData()->GetArray(ToolAxisName) != nullptr;
}

std::string checkAxes(vtkPolyData* tips)
{
  vtkAbstractArray* found = tips->GetPointData()->GetAbstractArray(ToolAxisName);
  if (!found)
  {
    return {};
  }
  auto* axes = vtkDataArray::SafeDownCast(found);
  if (!axes || axes->GetNumberOfComponents() != 3 ||
    axes->GetNumberOfTuples() != tips->GetNumberOfPoints())
  {
    return joined("the point array '", ToolAxisName, "' must hold three numbers per point, but is ",
      shapeOf(found));
  }
  for (vtkIdType tip = 0; tip < axes->GetNumberOfTuples(); ++tip)
  {
    Vector3 axis;
    axes->GetTuple(tip, axis.data());
    if (!ToolPose(Vector3::Zero(), axis).hasAxis())
    {
      return joined("the point array '", ToolAxisName, "' is (", axis[0], ", ", axis[1], ", ",
        axis[2], ") at point ", tip, ", but must be finite and not zero");
    }
  }
  return {};
}

TipPoses::TipPoses(const ContactBody& body, vtkPolyData* tips, double indentation)
  : Body(body)
  , Tips(tips)
  , Axes(tips->GetPointData()->GetArray(ToolAxisName))
  , Search(body.tree)
  , Indentation(indentation)
{
}

ToolPose TipPoses::at(vtkIdType tip)
{
  Vector3 position;
  this->Tips->GetPoint(tip, position.data());
  return this->at(tip, position);
}

ToolPose TipPoses::at(vtkIdType tip, const Vector3& position)
{
  Vector3 point;
  Vector3 normal;
  return this->poseAt(tip,
    this->findSite(position, point, normal) >= 0
      ? Vector3(position - this->Indentation / normal.norm() * normal)
      : position);
}

ToolPose TipPoses::onset(vtkIdType tip, const Vector3& position)
{
  // Depth below the triangle, as a fraction of the distance from the triangle's edges.
  constexpr double under = 0.1;
  Vector3 point;
  Vector3 normal;
  const std::int32_t triangle = this->findSite(position, point, normal);
  if (triangle < 0)
  {
    return this->poseAt(tip, position);
  }
  const PackedMesh& mesh = this->Body.surface;
  const std::array<Vector3, 3> corner = { mesh.corner(triangle, 0), mesh.corner(triangle, 1),
    mesh.corner(triangle, 2) };
  const Vector3 centroid = (corner[0] + corner[1] + corner[2]) / 3.0 + mesh.centre();
  const Vector3 inside = 0.5 * (point + centroid);
  double away = this->Indentation / under;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3 side = corner[(k + 1) % 3] - corner[k];
    away = std::min(away, side.cross(inside - mesh.centre() - corner[k]).norm() / side.norm());
  }
  return this->poseAt(tip, inside - under * away * mesh.faceNormal(triangle));
}

ToolPose TipPoses::poseAt(vtkIdType tip, const Vector3& position)
{
  if (!this->Axes)
  {
    return ToolPose(position);
  }
  Vector3 axis;
  this->Axes->GetTuple(tip, axis.data());
  return ToolPose(position, axis);
}

std::int32_t TipPoses::findSite(const Vector3& tip, Vector3& point, Vector3& normal)
{
  if (this->Indentation == 0.0)
  {
    return -1;
  }
  const SurfacePoint nearest = this->Search.closestLocal(this->Body.surface.toLocal(tip));
  if (nearest.triangle < 0)
  {
    return -1;
  }
  point = nearest.projection.point + this->Body.surface.centre();
  normal.setZero();
  for (int k = 0; k < 3; ++k)
  {
    normal += nearest.projection.weights[k] *
      this->Body.response.normal(
        this->Body.surface.corners(nearest.triangle)[static_cast<std::size_t>(k)]);
  }
  return normal.norm() > 0.0 ? nearest.triangle : -1;
}
} // namespace palpate
