// SPDX-License-Identifier: BSD-3-Clause
// Mouse, wheel and keys, as events of an interactor: position, depth and force of the tool, the
// camera, and the written files.
#include "Picture.h"
#include "SceneBodies.h"

#include "Haptics/Devices/Trajectory.h"
#include "Haptics/Devices/TrajectoryFile.h"
#include "vtkContactScene.h"
#include "vtkFrameClock.h"
#include "vtkHapticSession.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkSessionFiles.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkRenderWindowInteractor.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>

namespace
{
using namespace palpate::testing;

constexpr double Reduced = 3.45; // MPa, as in withResponse
constexpr double Radius = 1.0;   // mm, for the flat tool: F = 2 a E* d

/// A square of 30 mm seen from above, in the left half of a window. The right half is not
/// interactive.
struct Window
{
  Picture picture{ 800, 400 };
  vtkSmartPointer<vtkRenderer> left = picture.addRenderer(0.0, 0.5);
  vtkSmartPointer<vtkRenderer> right = picture.addRenderer(0.5, 1.0);
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkContactScene> scene;
  vtkNew<vtkHapticSession> session;
  vtkNew<vtkFrameClock> clock;
  vtkNew<vtkSessionFiles> files;
  vtkNew<vtkInteractorStyleHaptic> style;
  std::vector<std::pair<unsigned long, int>> heard; ///< events of the style, and their data
  vtkNew<vtkCallbackCommand> listener;
  double steered[3] = { 0.0, 0.0, 0.0 };

  Window()
  {
    const Body body = withResponse(planeBody(15.0, 15), "flat:1");
    this->interactor->SetRenderWindow(this->picture.window);
    this->scene->SetRenderer(this->left);
    this->scene->SetBody(body);
    this->scene->SetTool(makeTool("flat:1"));
    this->session->SetBody(body);
    this->session->RealTimeOn();
    this->session->GetRecorder()->RecordingOff();
    this->session->GetRecorder()->SetHistorySeconds(5.0);
    this->style->SetSession(this->session);
    this->style->SetScene(this->scene);
    this->style->SetFiles(this->files);
    this->files->SetSession(this->session);
    this->files->SetWindow(this->picture.window);
    this->clock->SetInteractor(this->interactor);
    this->scene->Follow(this->clock, this->session);
    this->interactor->SetInteractorStyle(this->style);
    this->right->InteractiveOff();
    const double up[3] = { 0.0, 1.0, 0.0 };
    const double from[3] = { 0.0, 0.0, 1.0 };
    const double start[3] = { 0.0, 0.0, 3.0 };
    this->session->GetDevice()->SteerTo(start);
    this->scene->ShowContact(start, start, from, start, 0.0, -1);
    this->scene->LookAtContact(80.0, from, up);
    this->picture.window->Render();
    this->listener->SetClientData(this);
    this->listener->SetCallback(
      [](vtkObject*, unsigned long event, void* client, void* data)
      {
        auto* window = static_cast<Window*>(client);
        const bool isTool = event == vtkInteractorStyleHaptic::ToolChosenEvent;
        window->heard.emplace_back(event, isTool ? *static_cast<int*>(data) : 0);
        if (event == vtkInteractorStyleHaptic::SteeredEvent)
        {
          std::copy_n(static_cast<double*>(data), 3, window->steered);
        }
      });
    for (unsigned long event = vtkInteractorStyleHaptic::ToolChosenEvent;
         event <= vtkInteractorStyleHaptic::HistogramEvent; ++event)
    {
      this->style->AddObserver(event, this->listener);
    }
    PALPATE_CHECK(this->session->Start());
  }

  void pointAt(double x, double y)
  {
    this->left->SetWorldPoint(x, y, 0.0, 1.0);
    this->left->WorldToDisplay();
    const double* place = this->left->GetDisplayPoint();
    this->pointAtPixel(
      static_cast<int>(std::lround(place[0])), static_cast<int>(std::lround(place[1])));
  }
  void pointAtPixel(int x, int y)
  {
    this->interactor->SetEventInformation(x, y);
    this->send(vtkCommand::MouseMoveEvent);
  }
  void send(unsigned long event, int times = 1)
  {
    for (int i = 0; i < times; ++i)
    {
      this->interactor->InvokeEvent(event);
    }
  }
  void type(char key)
  {
    this->interactor->SetKeyCode(key);
    this->send(vtkCommand::CharEvent);
  }
  bool hears(unsigned long event, int number = 0)
  {
    const bool found = !this->heard.empty() && this->heard.back() == std::pair(event, number);
    this->heard.clear();
    return found;
  }

  /// Waits for a limited time until the hand is at its last target. Returns whether this target is
  /// at the given height.
  bool reaches(double height)
  {
    double away = 1.0;
    for (int i = 0; i < 60000 && away > 1e-9; ++i)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      double tip[3];
      this->session->GetTip(tip);
      away = std::sqrt(vtkMath::Distance2BetweenPoints(tip, this->steered));
    }
    return away <= 1e-9 && std::abs(this->steered[2] - height) < 1e-9;
  }
  double force()
  {
    double ideal[3];
    this->session->GetIdealForce(ideal);
    return vtkMath::Norm(ideal);
  }
};

/// A wheel event that does not press is not counted as pressing: a turn backward, or with the
/// pointer off the body.
void checkIdleWheel(Window& w)
{
  w.pointAt(3.0, 2.0);
  w.send(vtkCommand::MouseWheelBackwardEvent);
  w.pointAtPixel(600, 200);
  w.send(vtkCommand::MouseWheelForwardEvent);
  PALPATE_CHECK(!w.style->HasWheelPressed() && w.style->GetWheelDepth() == 0.0);
}

void checkSurface(Window& w)
{
  const double pixel = 2.0 * 80.0 * std::tan(vtkMath::RadiansFromDegrees(15.0)) / 400.0; // mm
  w.pointAt(3.0, 2.0);
  PALPATE_CHECK(w.reaches(3.0)); // the hover height
  double tip[3];
  w.session->GetTip(tip);
  PALPATE_CHECK_NEAR(tip[0], 3.0, pixel);
  PALPATE_CHECK_NEAR(tip[1], 2.0, pixel);
  PALPATE_CHECK(w.session->GetDeflection() == 0.0 && w.force() == 0.0);
  w.send(vtkCommand::LeftButtonPressEvent);
  PALPATE_CHECK(w.style->IsPressing() && w.reaches(-1.0));
  PALPATE_CHECK_NEAR(w.session->GetDeflection(), 1.0, 1e-6); // the kernel's points are floats
  PALPATE_CHECK_NEAR(w.force(), 2.0 * Radius * Reduced * 1.0, 1e-5);
  PALPATE_CHECK(!w.style->HasWheelPressed());
  w.send(vtkCommand::MouseWheelForwardEvent, 5);
  PALPATE_CHECK(w.style->HasWheelPressed());
  PALPATE_CHECK(w.reaches(-1.5));
  PALPATE_CHECK_NEAR(w.force(), 2.0 * Radius * Reduced * 1.5, 1e-5);
  w.send(vtkCommand::MouseWheelForwardEvent, 10);
  PALPATE_CHECK(w.reaches(-2.0)); // limited to MaximumDepth
  PALPATE_CHECK(w.style->IsAtGreatestDepth());
  w.send(vtkCommand::MouseWheelBackwardEvent);
  PALPATE_CHECK(w.reaches(-1.9) && !w.style->IsAtGreatestDepth());
  w.send(vtkCommand::MouseWheelForwardEvent);
  PALPATE_CHECK(w.reaches(-2.0) && !w.style->IsAtGreatestDepth()); // just reached
  w.pointAt(-4.0, 1.0);
  PALPATE_CHECK(w.reaches(-2.0));
  w.session->GetTip(tip);
  PALPATE_CHECK_NEAR(tip[0], -4.0, pixel);
  w.send(vtkCommand::LeftButtonReleaseEvent);
  PALPATE_CHECK(!w.style->IsPressing() && w.reaches(3.0));
  // The wheel alone also presses.
  w.send(vtkCommand::MouseWheelForwardEvent, 3);
  PALPATE_CHECK(w.reaches(-0.3));
  PALPATE_CHECK_NEAR(w.force(), 2.0 * Radius * Reduced * 0.3, 1e-5);
  w.send(vtkCommand::MouseWheelBackwardEvent, 3);
  PALPATE_CHECK(w.style->GetWheelDepth() == 0.0 && w.reaches(3.0));
}

/// The left button keeps the depth that the wheel has set, also while the wheel turns.
void checkButtonAfterWheel(Window& w)
{
  w.style->SetPressDepth(0.8);
  w.pointAt(3.0, 2.0);
  w.send(vtkCommand::MouseWheelForwardEvent, 14);
  PALPATE_CHECK(w.reaches(-1.4));
  w.send(vtkCommand::LeftButtonPressEvent);
  PALPATE_CHECK(w.style->IsPressing() && w.reaches(-1.4));
  w.pointAt(4.0, 2.0);
  PALPATE_CHECK(w.reaches(-1.4));
  w.send(vtkCommand::MouseWheelForwardEvent, 2);
  PALPATE_CHECK(w.reaches(-1.6) && w.style->GetPressDepth() == 0.8);
  w.send(vtkCommand::LeftButtonReleaseEvent);
  PALPATE_CHECK(w.reaches(-1.6));
  w.send(vtkCommand::MouseWheelBackwardEvent, 16);
  PALPATE_CHECK(w.reaches(3.0));
  w.send(vtkCommand::LeftButtonPressEvent);
  PALPATE_CHECK(w.reaches(-0.8));
  w.send(vtkCommand::LeftButtonReleaseEvent);
  PALPATE_CHECK(w.reaches(3.0));
}

/// A tool that presses keeps its place and depth while the pointer is off the body. The style
/// reports that the pointer is off the body, but not for a hovering tool or a pointer in another
/// viewport.
void checkOffBody(Window& w)
{
  w.pointAt(3.0, 2.0);
  PALPATE_CHECK(w.reaches(3.0) && !w.style->IsPointerOffBody());
  w.pointAtPixel(3, 396);
  PALPATE_CHECK(!w.style->IsPointerOffBody()); // the tool hovers
  w.pointAt(3.0, 2.0);
  w.send(vtkCommand::MouseWheelForwardEvent, 5);
  PALPATE_CHECK(w.reaches(-0.5) && !w.style->IsPointerOffBody());
  double before[3];
  w.session->GetTip(before);
  w.pointAtPixel(3, 396);
  PALPATE_CHECK(w.style->IsPointerOffBody());
  double after[3];
  w.session->GetTip(after);
  constexpr double rest = 0.05; // mm; the hand may still move slightly
  PALPATE_CHECK(vtkMath::Distance2BetweenPoints(before, after) < rest * rest);
  w.pointAtPixel(600, 200);
  PALPATE_CHECK(!w.style->IsPointerOffBody());
  w.pointAt(3.0, 2.0);
  PALPATE_CHECK(!w.style->IsPointerOffBody());
  w.send(vtkCommand::MouseWheelBackwardEvent, 5);
  PALPATE_CHECK(w.reaches(3.0));
}

void checkCamera(Window& w)
{
  vtkCamera* camera = w.left->GetActiveCamera();
  vtkCamera* other = w.right->GetActiveCamera();
  w.pointAt(0.0, 0.0);
  const double far = camera->GetDistance();
  w.interactor->SetControlKey(1);
  w.send(vtkCommand::MouseWheelForwardEvent);
  w.interactor->SetControlKey(0);
  PALPATE_CHECK(camera->GetDistance() < far && w.style->GetWheelDepth() == 0.0);
  // Events in the other viewport have no effect: no steering, no orbit, no zoom of any camera.
  double before[3];
  double otherBefore[3];
  camera->GetPosition(before);
  other->GetPosition(otherBefore);
  w.heard.clear();
  w.pointAtPixel(600, 200);
  w.send(vtkCommand::LeftButtonPressEvent);
  w.pointAtPixel(650, 230);
  w.send(vtkCommand::LeftButtonReleaseEvent);
  w.send(vtkCommand::MouseWheelForwardEvent);
  PALPATE_CHECK(w.heard.empty());
  PALPATE_CHECK(std::equal(before, before + 3, camera->GetPosition()));
  PALPATE_CHECK(std::equal(otherBefore, otherBefore + 3, other->GetPosition()));
  // With the pointer off the body, the camera orbits, and the tool does not move.
  w.pointAtPixel(3, 396);
  w.send(vtkCommand::LeftButtonPressEvent);
  w.pointAtPixel(60, 340);
  w.send(vtkCommand::LeftButtonReleaseEvent);
  PALPATE_CHECK(w.heard.empty());
  PALPATE_CHECK(std::abs(before[0] - camera->GetPosition()[0]) > 1.0);
  camera->SetPosition(before);
  camera->SetViewUp(0.0, 1.0, 0.0);
}

/// The key r restores direction and distance of the first view of the body. (The last check, since
/// it changes the camera.)
void checkReset(Window& w)
{
  const double from[3] = { 0.3, -0.2, 1.0 };
  const double up[3] = { 0.0, 1.0, 0.0 };
  w.scene->LookAtBody(from, up);
  vtkCamera* camera = w.left->GetActiveCamera();
  double position[3];
  double upwards[3];
  camera->GetPosition(position);
  camera->GetViewUp(upwards);
  camera->Azimuth(70.0);
  camera->Elevation(20.0);
  camera->Zoom(3.0);
  camera->Dolly(2.0);
  PALPATE_CHECK(vtkMath::Distance2BetweenPoints(position, camera->GetPosition()) > 1.0);
  w.type('r');
  PALPATE_CHECK_NEAR(vtkMath::Distance2BetweenPoints(position, camera->GetPosition()), 0.0, 1e-12);
  PALPATE_CHECK_NEAR(vtkMath::Distance2BetweenPoints(upwards, camera->GetViewUp()), 0.0, 1e-12);
}

/// In the plane of the view the tip keeps its distance from the viewer; the wheel changes this
/// distance.
void checkViewPlane(Window& w)
{
  w.pointAt(0.0, 0.0);
  PALPATE_CHECK(w.reaches(3.0));
  w.type('v');
  PALPATE_CHECK(w.style->GetSteering() == vtkInteractorStyleHaptic::ViewPlane);
  w.pointAt(5.0, 5.0);
  w.pointAt(2.0, -1.0);
  PALPATE_CHECK(w.reaches(3.0));
  w.send(vtkCommand::MouseWheelForwardEvent, 35); // the view direction is -z
  PALPATE_CHECK(w.reaches(-0.5));
  PALPATE_CHECK_NEAR(w.session->GetDeflection(), 0.5, 1e-6);
  PALPATE_CHECK_NEAR(w.force(), 2.0 * Radius * Reduced * 0.5, 1e-5);
  w.type('v');
}

void checkKeys(Window& w)
{
  using Style = vtkInteractorStyleHaptic;
  PALPATE_CHECK(!w.style->GetHelpVisibility());
  const int props = w.left->GetViewProps()->GetNumberOfItems();
  w.type('?');
  PALPATE_CHECK(w.style->GetHelpVisibility() && w.left->GetViewProps()->GetNumberOfItems() > props);
  w.type('?');
  PALPATE_CHECK(
    !w.style->GetHelpVisibility() && w.left->GetViewProps()->GetNumberOfItems() == props);
  w.type('+');
  w.type('+');
  PALPATE_CHECK(w.scene->GetExaggeration() == 4.0);
  w.type('-');
  w.type('-');
  w.type('-');
  PALPATE_CHECK(w.scene->GetExaggeration() == 1.0);
  w.heard.clear();
  w.type('7');
  PALPATE_CHECK(w.hears(Style::ToolChosenEvent, 6));
  w.type(' ');
  PALPATE_CHECK(w.hears(Style::SwitchEvent));
  w.type('c');
  PALPATE_CHECK(w.hears(Style::CompareEvent));
  w.type('g');
  PALPATE_CHECK(w.hears(Style::ChartsEvent));
  w.type('t');
  PALPATE_CHECK(w.hears(Style::HistogramEvent));
  w.type('x');
  PALPATE_CHECK(w.session->GetState() == vtkHapticSession::Stopped);
  w.type('x');
  PALPATE_CHECK(w.session->GetState() == vtkHapticSession::Running);
  w.clock->AddObserver(vtkFrameClock::FrameEvent, w.listener);
  w.heard.clear();
  w.clock->ShowFrame();
  PALPATE_CHECK(w.hears(vtkFrameClock::FrameEvent));
}

void checkFiles(Window& w, const std::filesystem::path& folder)
{
  std::filesystem::remove_all(folder);
  w.files->SetOutputFolder(folder.string());
  w.type('k');
  PALPATE_CHECK(w.files->IsRecording());
  w.pointAt(1.0, 1.0);
  w.send(vtkCommand::LeftButtonPressEvent);
  w.style->SetPressDepth(1.0);
  w.pointAt(1.0, 1.0);
  PALPATE_CHECK(w.reaches(-1.0));
  w.clock->ShowFrame();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  w.type('k');
  w.send(vtkCommand::LeftButtonReleaseEvent);
  PALPATE_CHECK(!w.files->IsRecording());
  palpate::Trajectory trajectory;
  PALPATE_CHECK(palpate::readTrajectory((folder / "palpate-1.csv").string(), trajectory).empty());
  const auto count = static_cast<std::size_t>(w.files->GetNumberOfRecordedTicks());
  PALPATE_CHECK(count > 10 && trajectory.rows.size() == count);
  PALPATE_CHECK_NEAR(trajectory.rows.back().tip.z(), -1.0, 1e-9); // converted to m and back to mm
  double period = 1.0;
  for (std::size_t i = 1; i < count; ++i)
  {
    period = std::min(period, trajectory.rows[i].time - trajectory.rows[i - 1].time);
  }
  PALPATE_CHECK_NEAR(period, 1e-3, 1e-9); // no tick occurs twice
  w.type('p');
  w.type('p');
  for (const char* name : { "palpate-1.png", "palpate-2.png" })
  {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName((folder / name).c_str());
    reader->Update();
    PALPATE_CHECK(reader->GetOutput()->GetDimensions()[0] == 800);
  }
  PALPATE_CHECK_TEXT(w.files->GetNotice(), "picture", "palpate-2.png");
  Messages messages(w.files);
  PALPATE_CHECK(w.files->WriteRecording().empty());
  PALPATE_CHECK_TEXT(messages.takeErrors(), "StartRecording");
}
} // namespace

int TestInteractorStyleHaptic(int, char*[])
{
  Window window;
  checkIdleWheel(window);
  checkSurface(window);
  checkButtonAfterWheel(window);
  checkOffBody(window);
  checkCamera(window);
  checkViewPlane(window);
  checkKeys(window);
  checkFiles(window, std::filesystem::current_path() / "TestInteractorStyleHaptic");
  window.session->Stop();
  checkReset(window);
  return palpate::testing::result();
}
