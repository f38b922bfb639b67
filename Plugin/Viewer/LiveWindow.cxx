// SPDX-License-Identifier: BSD-3-Clause
#include "LiveWindow.h"

#include "Pictures.h"
#include "ResponseSet.h"
#include "SessionSettings.h"

#include "vtkCallbackCommand.h"
#include "vtkContactScene.h"
#include "vtkDataArray.h"
#include "vtkHapticSession.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr int Width = 1280;
constexpr int Height = 960;
constexpr double FieldRadii = 10.0; // the field is drawn this many contact radii far

const char* const Help = "left on the body: press and slide   wheel while pressing: depth   "
                         "left beside it: orbit   1-9: tool   q: quit";

/// The window and what must change together when another tool is chosen.
class LiveTouch
{
public:
  LiveTouch(const ViewerOptions& options, const TouchScene& scene, const ResponseSet& responses)
    : Scene(scene)
    , Responses(responses)
  {
    this->Window->SetMultiSamples(0); // costs threefold without a graphics card; FXAA does not
    this->Renderer->UseFXAAOn();
    this->Window->SetSize(Width, Height);
    this->Window->SetWindowName(("Palpate: " + scene.title).c_str());
    this->Window->AddRenderer(this->Renderer);
    this->Interactor->SetRenderWindow(this->Window);
    this->View->SetRenderer(this->Renderer);
    this->View->SetBody(responses.body);
    this->View->SetTitle(scene.title);
    this->View->SetPoissonRatio(scene.poissonsRatio);
    this->View->SetLargestDeflection(options.maximumDeflection);
    this->Session->SetBody(responses.body);
    this->Session->SetRate(options.rate);
    chooseContact(options, scene, this->Session);
    this->Session->RealTimeOn();
    this->Style->SetSession(this->Session);
    this->Style->SetScene(this->View);
    this->Style->SetMaximumDepth(options.maximumDeflection);
    this->Style->SetPressDepth(scene.depth);
    this->Interactor->SetInteractorStyle(this->Style);
    this->addHelp();
    this->observeTools();
  }

  /// Shows the body with the tool above the first site of the scene.
  void open()
  {
    vtkPolyData* body = this->Responses.body;
    const vtkIdType site = this->siteOf(this->Scene.directions.front());
    double point[3];
    double normal[3];
    body->GetPoint(site, point);
    body->GetPointData()->GetArray("ResponseNormal")->GetTuple(site, normal);
    this->Style->HoverAt(point, normal);
    double tip[3];
    for (int k = 0; k < 3; ++k)
    {
      tip[k] = point[k] + this->Style->GetHoverHeight() * normal[k];
    }
    const double none[3] = { 0.0, 0.0, 0.0 };
    this->chooseLook(0);
    this->Interactor->Initialize();
    this->View->ShowContact(tip, point, normal, none, 0.0, -1);
    this->View->LookAtBody(this->Scene.viewFrom.data(), this->Scene.up.data());
    this->Window->Render();
    std::printf("window open\n");
    std::fflush(stdout);
  }

  /// Switches tool: the session begins anew with its responses, where the tip is.
  bool choose(std::size_t tool)
  {
    if (tool >= this->Responses.tools.size())
    {
      return false;
    }
    if (this->Session->GetState() == vtkHapticSession::Running)
    {
      double tip[3];
      this->Session->GetTip(tip);
      this->Session->SteerTo(tip);
    }
    this->Session->SetResponseName(this->Responses.names[tool]);
    this->chooseLook(tool);
    std::printf("tool: %s\n", this->Responses.tools[tool]->GetDescription().c_str());
    std::fflush(stdout);
    return this->Session->Start();
  }

  /// Until the window is closed; then writes its last picture, if asked to.
  std::string run(const std::string& screenshot)
  {
    this->Style->StartUpdates();
    this->Interactor->Start();
    std::string error;
    if (!screenshot.empty())
    {
      error = writePicture(this->Window, screenshot);
    }
    this->Session->Stop();
    this->printSummary();
    return error;
  }

  void setLargestForce(double force) { this->View->SetLargestForce(force); }

private:
  /// The outermost point of the body within two degrees of a direction from the centre.
  vtkIdType siteOf(const Direction& direction) const
  {
    constexpr double cosine = 0.9994;
    vtkPolyData* body = this->Responses.body;
    const double length = vtkMath::Norm(direction.data());
    vtkIdType best = 0;
    double farthest = 0.0;
    for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
    {
      double point[3];
      body->GetPoint(i, point);
      vtkMath::Subtract(point, this->Scene.center.data(), point);
      const double along = vtkMath::Dot(point, direction.data()) / length;
      if (along > farthest && along > cosine * vtkMath::Norm(point))
      {
        farthest = along;
        best = i;
      }
    }
    return best;
  }

  void chooseLook(std::size_t tool)
  {
    vtkContactTool* chosen = this->Responses.tools[tool];
    this->View->SetTool(chosen);
    this->View->SetFieldRadius(
      FieldRadii * chosen->GetContactRadius(this->Style->GetMaximumDepth()));
  }

  void printSummary()
  {
    std::printf("%lld ticks, %lld missed; strongest force %.4g N\n",
      static_cast<long long>(this->Session->GetNumberOfTicks()),
      static_cast<long long>(this->Session->GetNumberOfMissedTicks()),
      this->Style->GetStrongestForce());
  }

  void addHelp()
  {
    vtkNew<vtkTextActor> help;
    help->SetInput(Help);
    help->GetTextProperty()->SetFontSize(15);
    help->GetTextProperty()->SetColor(0.35, 0.35, 0.38);
    help->GetTextProperty()->SetVerticalJustificationToTop();
    help->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    help->GetPositionCoordinate()->SetValue(0.0125, 0.985);
    this->Renderer->AddViewProp(help);
  }

  void observeTools()
  {
    vtkNew<vtkCallbackCommand> chosen;
    chosen->SetClientData(this);
    chosen->SetCallback(
      [](vtkObject*, unsigned long, void* client, void* tool)
      {
        static_cast<LiveTouch*>(client)->choose(
          static_cast<std::size_t>(*static_cast<const int*>(tool)));
      });
    this->Style->AddObserver(vtkInteractorStyleHaptic::ToolChosenEvent, chosen);
  }

  const TouchScene& Scene;
  const ResponseSet& Responses;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkContactScene> View;
  vtkNew<vtkHapticSession> Session;
  vtkNew<vtkInteractorStyleHaptic> Style;
};

/// The largest stored force of any tool, N; 1 where the curves are stored in the compact form.
double largestForce(const ResponseSet& responses)
{
  double largest = 0.0;
  for (const std::string& name : responses.names)
  {
    vtkDataArray* force = responses.body->GetPointData()->GetArray((name + "Force").c_str());
    if (force)
    {
      double range[2];
      force->GetRange(range, force->GetNumberOfComponents() - 1);
      largest = std::max(largest, range[1]);
    }
  }
  return largest > 0.0 ? largest : 1.0;
}
} // namespace

std::string runLive(const ViewerOptions& options, const TouchScene& scene)
{
  ResponseSet responses;
  const std::string error = prepareResponses(options, scene, responses);
  if (!error.empty())
  {
    return error;
  }
  LiveTouch live(options, scene, responses);
  live.setLargestForce(largestForce(responses));
  live.open();
  if (!live.choose(0))
  {
    return "the session did not start";
  }
  return live.run(options.screenshot);
}
} // namespace palpate
