// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneView_h
#define SceneView_h

#include "Interaction/Display/DisplayColors.h"

#include "vtkLightKit.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <Eigen/Core>

namespace palpate
{
/// The direction from the focus to the camera, and the upward direction in the picture. Neither
/// vector may be zero.
struct ViewDirection
{
  Eigen::Vector3d from;
  Eigen::Vector3d up;
};

/// Moves the camera so that it shows the whole box, centred in the part of the picture to the left
/// of the legends. `column` is the fraction of the picture's width that the column of legends
/// occupies.
void lookAtBounds(
  vtkRenderer* renderer, const double bounds[6], const ViewDirection& view, double column);

/// Moves the camera to the distance `distance` (mm) from a point. The point appears a little below
/// the middle of the picture, so that an arrow above it is visible.
void lookAtPoint(vtkRenderer* renderer, const Eigen::Vector3d& point, double distance,
  const ViewDirection& view, double column);

/// Number of pixels per mm at a point, perpendicular to the line of sight.
double pixelsPerMillimetre(vtkRenderer* renderer, const Eigen::Vector3d& point);

/// Sets background and lights. They are the same for all bodies.
inline void lightScene(vtkRenderer* renderer)
{
  renderer->SetBackground(BackgroundColor[0], BackgroundColor[1], BackgroundColor[2]);
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.75);
  lights->SetKeyToFillRatio(2.0);
  lights->SetKeyToHeadRatio(2.2);
  lights->AddLightsToRenderer(renderer);
}
} // namespace palpate

#endif
