// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/TipPoses.h"

#include "Mechanics/JoinedText.h"
#include "Response/ArrayFetch.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

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
    this->findSite(position, point, normal)
      ? Vector3(position - this->Indentation / normal.norm() * normal)
      : position);
}

ToolPose TipPoses::onset(vtkIdType tip, const Vector3& position)
{
  constexpr double part = 1e-3; // of the indentation
  Vector3 point;
  Vector3 normal;
  return this->poseAt(tip,
    this->findSite(position, point, normal)
      ? Vector3(point - part * this->Indentation / normal.norm() * normal)
      : position);
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

bool TipPoses::findSite(const Vector3& tip, Vector3& point, Vector3& normal)
{
  if (this->Indentation == 0.0)
  {
    return false;
  }
  const SurfacePoint nearest = this->Search.closestLocal(this->Body.surface.toLocal(tip));
  if (nearest.triangle < 0)
  {
    return false;
  }
  point = nearest.projection.point + this->Body.surface.centre();
  normal.setZero();
  for (int k = 0; k < 3; ++k)
  {
    normal += nearest.projection.weights[k] *
      this->Body.response.normal(
        this->Body.surface.corners(nearest.triangle)[static_cast<std::size_t>(k)]);
  }
  return normal.norm() > 0.0;
}
} // namespace palpate
