// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Panel/SteeredHand.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace palpate
{
void SteeredTilt::set(double right, double away)
{
  this->Right = std::clamp(right, -Largest, Largest);
  this->Away = std::clamp(away, -Largest, Largest);
  this->IsSet = this->IsSet || this->Right != 0.0 || this->Away != 0.0;
}

std::array<double, 3> SteeredTilt::axis(const double normal[3], vtkRenderer* renderer) const
{
  const Eigen::Vector3d up = Eigen::Vector3d(normal).normalized();
  Eigen::Vector3d toRight = Eigen::Vector3d::UnitX();
  if (renderer)
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    toRight = Eigen::Vector3d(camera->GetDirectionOfProjection())
                .cross(Eigen::Vector3d(camera->GetViewUp()));
  }
  Eigen::Vector3d across = toRight - up.dot(toRight) * up;
  // If the surface is seen from the side, the direction to the right may be parallel to the normal.
  // In this case any direction perpendicular to the normal is used.
  across = across.norm() > 1e-3 * toRight.norm() ? across.normalized() : up.unitOrthogonal();
  const Eigen::Vector3d ahead = up.cross(across);
  const Eigen::Vector3d along = (up + std::tan(vtkMath::RadiansFromDegrees(this->Right)) * across +
    std::tan(vtkMath::RadiansFromDegrees(this->Away)) * ahead)
                                  .normalized();
  return { along.x(), along.y(), along.z() };
}
} // namespace palpate
