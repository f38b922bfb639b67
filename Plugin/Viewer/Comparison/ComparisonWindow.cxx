// SPDX-License-Identifier: BSD-3-Clause
#include "ComparisonWindow.h"

#include "ViewerModules.h"
#include "ComparisonStage.h"
#include "EventActions.h"
#include "PictureSize.h"
#include "Pictures.h"
#include "SessionSettings.h"

#include "vtkContactScene.h"
#include "vtkFrameClock.h"
#include "vtkHapticSession.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSessionFiles.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr float PriorityOverStyle = 1.0F;

const char* const Hint = "? or h: keys and mouse";
const char* const KeySheet =
  "left button on a body\tpress, and slide with the pointer: on both bodies\n"
  "wheel\tdeeper, less deep\n"
  "left button next to it\torbit; middle: pan; right: zoom\n"
  "\n"
  "1 to 9\tthe tool\n"
  "m\tcolour: displacement, regime index, sensitivity, verdict\n"
  "+, -\texaggerate the dent of the body under the pointer\n"
  "p\tpicture of the window\n"
  "? or h\tthis help\n"
  "q\tquit";

/// Shows two bodies in a window, with a session on each body. Both tools are steered to the same
/// point.
class ComparisonWindow
{
public:
  ComparisonWindow(const ViewerOptions& options, const std::array<ComparedBody, 2>& bodies);

  /// Runs until the window is closed. Returns "" or an error.
  std::string run();

private:
  /// Makes the body of `side`, which is under the mouse, the body on which the pointer picks
  /// points.
  void lead(std::size_t side);
  void followPointer();
  void showFrame();
  void chooseTool(int tool);
  void chooseColor();
  void showHint();

  const ViewerOptions& Options;
  const std::array<ComparedBody, 2>& Bodies;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkBodyComparison> Comparison;
  vtkNew<vtkFrameClock> Clock;
  vtkNew<vtkSessionFiles> Files;
  vtkNew<vtkInteractorStyleHaptic> Style;
  std::array<vtkNew<vtkHapticSession>, 2> Sessions;
  std::size_t Leader = 1;
  std::array<double, 2> Strongest{}; ///< largest ideal force in any frame, N
  EventActions Actions;
};

ComparisonWindow::ComparisonWindow(
  const ViewerOptions& options, const std::array<ComparedBody, 2>& bodies)
  : Options(options)
  , Bodies(bodies)
{
  // Without a graphics card, multisampling would triple the rendering time; FXAA does not increase
  // it.
  this->Window->SetMultiSamples(0);
  fitToScreen(this->Window);
  this->Window->SetWindowName("Palpate: global and local deformation");
  this->Interactor->SetRenderWindow(this->Window);
  this->Comparison->SetRenderWindow(this->Window);
  setStage(this->Comparison, bodies);
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    vtkHapticSession* session = this->Sessions[i];
    session->SetBody(bodies[i].responses.body);
    session->SetRate(options.rate);
    chooseContact(options, bodies[i].scene, session);
    session->RealTimeOn();
    session->LockMemoryOn(); // permitted, because the servo loop is the purpose of this program
    session->GetRecorder()->RecordingOff();
  }
  this->Style->SetMaximumDepth(options.maximumDeflection);
  this->Style->SetPressDepth(bodies[0].scene.depth);
  this->Style->SetKeyHelp(KeySheet);
  this->Clock->SetInteractor(this->Interactor);
  this->Files->SetWindow(this->Window);
  this->Style->SetFiles(this->Files);
  this->Interactor->SetInteractorStyle(this->Style);
  this->lead(0);
  this->showHint();

  this->Actions.add(
    this->Interactor, vtkCommand::MouseMoveEvent, [this](void*) { this->followPointer(); },
    PriorityOverStyle);
  this->Actions.add(this->Interactor, vtkCommand::CharEvent,
    [this](void*)
    {
      if (this->Interactor->GetKeyCode() == 'm')
      {
        this->chooseColor();
      }
    });
  this->Actions.add(this->Style, vtkInteractorStyleHaptic::SteeredEvent,
    [this](void*) { this->Style->SteerAlike(this->Sessions[1 - this->Leader]->GetDevice()); });
  this->Actions.add(this->Clock, vtkFrameClock::FrameEvent, [this](void*) { this->showFrame(); });
  this->Actions.add(this->Style, vtkInteractorStyleHaptic::ToolChosenEvent,
    [this](void* tool) { this->chooseTool(*static_cast<const int*>(tool)); });
}

void ComparisonWindow::lead(std::size_t side)
{
  if (side != this->Leader)
  {
    this->Leader = side;
    this->Files->SetSession(this->Sessions[side]);
    this->Style->SetSession(this->Sessions[side]);
    this->Style->SetScene(this->Comparison->GetScene(static_cast<int>(side)));
  }
}

void ComparisonWindow::followPointer()
{
  const int* position = this->Interactor->GetEventPosition();
  for (int side = 0; side < 2 && !this->Style->IsPressing(); ++side)
  {
    if (this->Comparison->GetRenderer(side)->IsInViewport(position[0], position[1]))
    {
      this->lead(static_cast<std::size_t>(side));
    }
  }
}

void ComparisonWindow::showFrame()
{
  for (std::size_t i = 0; i < this->Sessions.size(); ++i)
  {
    std::array<double, 3> force{};
    this->Sessions[i]->GetIdealForce(force.data());
    this->Strongest[i] = std::max(this->Strongest[i], vtkMath::Norm(force.data()));
  }
  this->Comparison->ShowSessions(this->Sessions[0], this->Sessions[1]);
}

void ComparisonWindow::chooseTool(int tool)
{
  const ResponseSet& responses = this->Bodies[0].responses;
  const auto index = static_cast<std::size_t>(tool);
  if (index >= responses.tools.size())
  {
    return;
  }
  for (vtkHapticSession* session : { this->Sessions[0].Get(), this->Sessions[1].Get() })
  {
    session->SetResponseName(responses.names[index]);
    session->ApplyChanges();
  }
  this->Comparison->SetShownTool(tool);
  std::printf("tool: %s\n", responses.tools[index]->GetDescription().c_str());
  std::fflush(stdout);
}

void ComparisonWindow::chooseColor()
{
  const int color = (this->Comparison->GetColor() + 1) % (vtkBodyComparison::RegimeVerdict + 1);
  this->Comparison->SetColor(color);
  std::printf("colour: %d\n", color);
  std::fflush(stdout);
}

void ComparisonWindow::showHint()
{
  vtkNew<vtkTextActor> hint;
  hint->SetInput(Hint);
  hint->GetTextProperty()->SetFontSize(15);
  hint->GetTextProperty()->SetColor(0.35, 0.35, 0.38);
  hint->GetTextProperty()->SetVerticalJustificationToTop();
  hint->GetTextProperty()->SetJustificationToRight();
  hint->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  hint->GetPositionCoordinate()->SetValue(0.98, 0.98);
  this->Comparison->GetRenderer(vtkBodyComparison::Right)->AddViewProp(hint);
}

std::string ComparisonWindow::run()
{
  const double middle[3] = { 0.0, 0.0, 0.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  const ViewerScene& scene = this->Bodies[0].scene;
  this->Style->HoverAt(middle, up);
  this->Comparison->ShowPlace(middle[0], middle[1], middle[2]);
  // The colours are computed now, so that a later change of the colours is shown immediately.
  this->Comparison->SetColor(vtkBodyComparison::RegimeIndex);
  this->Comparison->SetColor(vtkBodyComparison::Displacement);
  this->Interactor->Initialize();
  for (vtkHapticSession* session : { this->Sessions[0].Get(), this->Sessions[1].Get() })
  {
    const std::string error = startQuietly(session);
    if (!error.empty())
    {
      return error;
    }
  }
  this->Comparison->ShowSessions(this->Sessions[0], this->Sessions[1]);
  this->Comparison->LookAtBodies(scene.viewFrom.data(), scene.up.data());
  this->Window->Render();
  std::printf("window open\n");
  this->chooseTool(0);
  this->Clock->Start();
  this->Interactor->Start();
  std::string error;
  if (!this->Options.screenshot.empty())
  {
    error = writePicture(this->Window, this->Options.screenshot);
  }
  for (vtkHapticSession* session : { this->Sessions[0].Get(), this->Sessions[1].Get() })
  {
    session->Stop();
  }
  std::printf(
    "strongest force: strip %.4g N, block %.4g N\n", this->Strongest[0], this->Strongest[1]);
  printStatements(this->Comparison, this->Bodies);
  return error;
}
} // namespace

std::string runComparisonWindow(const ViewerOptions& options)
{
  std::array<ComparedBody, 2> bodies;
  std::string error;
  if (const SolidsModule* solids = solidsModule("--compare", error))
  {
    error = solids->compareBodies(options, bodies);
  }
  return error.empty() ? ComparisonWindow(options, bodies).run() : error;
}
} // namespace palpate
