// SPDX-License-Identifier: BSD-3-Clause
#include "TouchSight.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderWindow.h"
#include "vtkSMRenderViewProxy.h"

#include <cmath>

namespace palpate
{
Sight sightOf(vtkSMProxy* view)
{
  auto* render = vtkSMRenderViewProxy::SafeDownCast(view);
  vtkCamera* camera = render ? render->GetActiveCamera() : nullptr;
  Sight sight;
  if (!camera)
  {
    return sight;
  }
  camera->GetDirectionOfProjection(sight.towards.data());
  sight.towards = -sight.towards;
  camera->GetViewUp(sight.up.data());
  camera->GetPosition(sight.eye.data());
  sight.isNear = camera->GetParallelProjection() == 0;
  vtkRenderWindow* window = render->GetRenderWindow();
  const int* size = window ? window->GetActualSize() : nullptr;
  const double aspect = size && size[0] > 0 && size[1] > 0 ? double(size[0]) / size[1] : 1.0;
  const double half = sight.isNear
    ? std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()))
    : camera->GetParallelScale();
  const bool isAcross = sight.isNear && camera->GetUseHorizontalViewAngle() != 0;
  sight.halfWidth = isAcross ? half : half * aspect;
  sight.halfHeight = isAcross ? half / aspect : half;
  return sight;
}
} // namespace palpate
