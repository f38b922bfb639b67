// SPDX-License-Identifier: BSD-3-Clause
#include "MapStage.h"

#include "PictureSize.h"
#include "Pictures.h"
#include "ResponseSet.h"
#include "Interaction/Display/SceneView.h"
#include "Response/BodyRegime.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkContactTool.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkPointData.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <cstdio>
#include <filesystem>

namespace palpate
{
namespace
{
constexpr int TextSize = 17;
// Zoom of the camera. ResetCamera fits the sphere around the body, which is larger than the body.
constexpr double Zoom = 1.25;
constexpr double LegendShare = 0.27;

vtkSmartPointer<vtkTextActor> makeText(const std::string& words, double x, double y)
{
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->SetInput(words.c_str());
  text->GetTextProperty()->SetColor(TextColor[0], TextColor[1], TextColor[2]);
  text->GetTextProperty()->SetFontSize(TextSize);
  text->GetTextProperty()->SetLineSpacing(1.3);
  text->GetTextProperty()->SetVerticalJustificationToTop();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->GetPositionCoordinate()->SetValue(x, y);
  return text;
}

void turn(vtkRenderWindow* window)
{
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(style);
  interactor->Initialize();
  window->Render();
  std::printf("window open\n");
  std::fflush(stdout);
  interactor->Start();
}
} // namespace

vtkSmartPointer<vtkPolyData> judgeBody(
  const ViewerScene& scene, vtkContactTool* tool, vtkPolyData* body, std::string& error)
{
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(body->GetPoints());
  bare->SetPolys(body->GetPolys());
  const ContactLaw law = lawOf(scene);
  auto judged = vtkSmartPointer<vtkPolyData>::New();
  error = attachRegime(
    Ranks(), bare, { tool, "", scene.depth, materialOf(law), arraysOf(law, scene, body) }, judged);
  return error.empty() ? judged : nullptr;
}

MapStage::MapStage(const std::string& name, bool onScreen)
{
  this->Window->SetOffScreenRendering(!onScreen);
  // Without multisampling, the pixels are the same on every machine.
  this->Window->SetMultiSamples(0);
  if (onScreen)
  {
    fitToScreen(this->Window);
  }
  else
  {
    this->Window->SetSize(PictureWidth, PictureHeight);
  }
  this->Window->SetWindowName(name.c_str());
}

vtkRenderer* MapStage::addRenderer(const Viewport& viewport)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetViewport(viewport.data());
  renderer->UseFXAAOn();
  lightScene(renderer);
  this->Window->AddRenderer(renderer);
  if (!this->Renderers.empty())
  {
    renderer->SetActiveCamera(this->Renderers.front()->GetActiveCamera());
  }
  // The clipping range is set before each rendering, because the camera is shared with bodies that
  // have other bounds.
  vtkNew<vtkCallbackCommand> fit;
  fit->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkRenderer*>(caller)->ResetCameraClippingRange(); });
  renderer->AddObserver(vtkCommand::StartEvent, fit);
  this->Renderers.push_back(renderer);
  return renderer;
}

vtkRenderer* MapStage::addMap(vtkPolyData* judged, int quantity, const Viewport& viewport)
{
  vtkRenderer* renderer = this->addRenderer(viewport);
  auto map = vtkSmartPointer<vtkRegimeMap>::New();
  map->SetRenderer(renderer);
  map->SetBody(judged);
  map->SetQuantity(quantity);
  this->Maps.push_back(map);
  return renderer;
}

void MapStage::addTitle(const std::string& title)
{
  this->Renderers.back()->AddViewProp(makeText(title, 0.02, 0.96));
}

void MapStage::addWords(const std::string& words, const Viewport& viewport)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(viewport.data());
  renderer->SetBackground(BackgroundColor[0], BackgroundColor[1], BackgroundColor[2]);
  renderer->InteractiveOff();
  renderer->AddViewProp(makeText(words, 0.06, 0.85));
  this->Window->AddRenderer(renderer);
}

void MapStage::lookFrom(vtkPolyData* body, const Direction& from, const Direction& up)
{
  vtkCamera* camera = this->Renderers.front()->GetActiveCamera();
  Direction centre{};
  body->GetCenter(centre.data());
  camera->SetFocalPoint(centre.data());
  camera->SetPosition(centre[0] + from[0], centre[1] + from[1], centre[2] + from[2]);
  camera->SetViewUp(up.data());
  this->Renderers.front()->ResetCamera(body->GetBounds());
  camera->Zoom(Zoom);
  camera->SetWindowCenter(LegendShare, 0.0); // centres the body in the area without the legend
}

std::string MapStage::show(const ViewerOptions& options)
{
  if (options.window)
  {
    turn(this->Window);
    return options.screenshot.empty() ? std::string()
                                      : writePicture(this->Window, options.screenshot);
  }
  std::error_code failed;
  std::filesystem::create_directories(options.output, failed);
  return failed ? "cannot make folder '" + options.output + "': " + failed.message()
                : writePicture(this->Window, options.output + "/map.png");
}
} // namespace palpate
