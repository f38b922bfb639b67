// SPDX-License-Identifier: BSD-3-Clause
// A blind scene has the same picture for every contact: tool, force and depth are not visible.
#include "Response/FilterChecks.h"
#include "SceneBodies.h"

#include "vtkContactScene.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <cstring>

namespace
{
using namespace palpate::testing;

/// Returns the picture of a tool that is pressed `depth` mm into the middle of a plane with a force
/// of `force` N.
vtkSmartPointer<vtkUnsignedCharArray> drawn(
  const char* tool, double depth, double force, bool blind, const char* remark = "X")
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(400, 300);
  window->AddRenderer(renderer);
  vtkNew<vtkContactScene> scene;
  scene->SetRenderer(renderer);
  scene->SetBody(withResponse(planeBody(20.0, 20), tool));
  scene->SetTool(makeTool(tool));
  scene->SetTitle("Plane");
  scene->SetBlind(blind);
  scene->SetRemark(remark);
  const double tip[3] = { 0.3, 0.2, -depth };
  const double contact[3] = { 0.3, 0.2, 0.0 };
  const double normal[3] = { 0.0, 0.0, 1.0 };
  const double felt[3] = { 0.0, 0.0, force };
  scene->ShowContact(tip, contact, normal, felt, depth, 400);
  const double from[3] = { 0.0, -1.0, 0.7 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  scene->LookAtBody(from, up);
  window->Render();
  auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  window->GetPixelData(0, 0, 399, 299, 0, pixels);
  return pixels;
}

bool same(vtkUnsignedCharArray* one, vtkUnsignedCharArray* other)
{
  return one->GetNumberOfValues() == other->GetNumberOfValues() &&
    std::memcmp(one->GetPointer(0), other->GetPointer(0),
      static_cast<std::size_t>(one->GetNumberOfValues())) == 0;
}
} // namespace

int TestContactSceneBlind(int, char*[])
{
  const auto blind = drawn("flat:1.6", 1.0, 11.0, true);
  PALPATE_CHECK(same(blind, drawn("sphere:6.35", 1.0, 11.0, true)));
  PALPATE_CHECK(same(blind, drawn("flat:1.6", 1.0, 3.0, true)));
  PALPATE_CHECK(same(blind, drawn("flat:1.6", 0.4, 11.0, true)));
  // The remark is visible. In a scene that is not blind, everything is visible.
  PALPATE_CHECK(!same(blind, drawn("flat:1.6", 1.0, 11.0, true, "Y")));
  const auto seen = drawn("flat:1.6", 1.0, 11.0, false);
  PALPATE_CHECK(!same(seen, blind));
  PALPATE_CHECK(!same(seen, drawn("sphere:6.35", 1.0, 11.0, false)));
  PALPATE_CHECK(!same(seen, drawn("flat:1.6", 1.0, 3.0, false)));
  PALPATE_CHECK(!same(seen, drawn("flat:1.6", 0.4, 11.0, false)));
  return palpate::testing::result();
}
