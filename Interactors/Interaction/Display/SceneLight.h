// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneLight_h
#define SceneLight_h

#include "Interaction/Display/DisplayColors.h"

#include "vtkLightKit.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

namespace palpate
{
/// Background and light in which all bodies are seen.
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
