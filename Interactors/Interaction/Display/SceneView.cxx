// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/SceneView.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <Eigen/Geometry>

namespace palpate
{
namespace
{
/// Height of the camera's focus above the point, as a fraction of the distance.
constexpr double RaisedFocus = 0.09;

void placeCamera(vtkCamera* camera, const Eigen::Vector3d& focus, const Eigen::Vector3d& position,
  const Eigen::Vector3d& up)
{
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(up.data());
}
} // namespace

void lookAtBounds(
  vtkRenderer* renderer, const double bounds[6], const ViewDirection& view, double column)
{
  const Eigen::Vector3d focus(
    0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 0.5 * (bounds[4] + bounds[5]));
  vtkCamera* camera = renderer->GetActiveCamera();
  placeCamera(camera, focus, focus + view.from, view.up);
  renderer->ResetCamera(bounds);
  camera->Zoom(1.15);
  camera->SetWindowCenter(column, 0.0);
  renderer->ResetCameraClippingRange();
}

void lookAtPoint(vtkRenderer* renderer, const Eigen::Vector3d& point, double distance,
  const ViewDirection& view, double column)
{
  const Eigen::Vector3d focus = point + RaisedFocus * distance * view.up.normalized();
  vtkCamera* camera = renderer->GetActiveCamera();
  placeCamera(camera, focus, focus + distance * view.from.normalized(), view.up);
  camera->SetWindowCenter(column, 0.0);
  renderer->ResetCameraClippingRange();
}

double pixelsPerMillimetre(vtkRenderer* renderer, const Eigen::Vector3d& point)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d ahead(camera->GetDirectionOfProjection());
  const Eigen::Vector3d right = ahead.cross(Eigen::Vector3d(camera->GetViewUp())).normalized();
  const auto inPicture = [&](Eigen::Vector3d world) -> Eigen::Vector2d
  {
    renderer->WorldToView(world.x(), world.y(), world.z());
    return { 0.5 * renderer->GetSize()[0] * world.x(), 0.5 * renderer->GetSize()[1] * world.y() };
  };
  return (inPicture(point + right) - inPicture(point)).norm();
}
} // namespace palpate
