// SPDX-License-Identifier: BSD-3-Clause
// A picture: from a session that has run its ticks to the drawn scene. The ticks run before.
#include "Counted.h"
#include "Picture.h"
#include "SceneBodies.h"

#include "vtkContactScene.h"
#include "vtkContactSettings.h"
#include "vtkHapticDevice.h"
#include "vtkHapticSession.h"

#include <cstdio>

using namespace palpate::testing;

int main()
{
  constexpr double from[3] = { 0.2, -1.0, 0.0 };
  constexpr double to[3] = { -0.2, -1.0, 0.0 };
  const Body body = withResponse(sphereBody(40.0, 4), "sphere:6.35");
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->GetDevice()->Open("simulated");
  session->GetDevice()->SetPath(slidePath(body, from, to, 1.0));
  session->GetSettings()->SetFrictionCoefficient(0.3);
  if (!session->Start())
  {
    return 1;
  }
  session->Step(1.5);
  vtkNew<vtkContactTool> tool;
  tool->SetShapeToSphere();
  palpate::reading::counted(
    [&]
    {
      Picture picture(400, 300);
      const auto renderer = picture.addRenderer();
      vtkNew<vtkContactScene> scene;
      scene->SetRenderer(renderer);
      scene->SetBody(body);
      scene->SetTool(tool);
      scene->SetLargestDeflection(1.0);
      scene->SetLargestForce(10.0);
      scene->LookAtBody(from, to);
      scene->ShowSession(session);
      picture.window->Render();
    });
  std::printf("%g mm\n", session->GetDeflection());
  return 0;
}
