// SPDX-License-Identifier: BSD-3-Clause
// Events of the interactor drag sliders and press buttons while a hand presses. The force after
// each change is compared with the closed form of the tool.
#include "Picture.h"
#include "SceneBodies.h"
#include "SceneParts.h"

#include "Haptics/Devices/TrajectoryFile.h"
#include "Haptics/Servo/ServoStep.h"
#include "Haptics/Devices/RecordedSetup.h"

#include "vtkContactPanel.h"
#include "vtkContactScene.h"
#include "vtkContactSetup.h"
#include "vtkFrameClock.h"
#include "vtkHapticSession.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkSessionFiles.h"

#include "vtkPropCollection.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkTextActor.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>
#include <thread>

namespace
{
using namespace palpate::testing;

constexpr double Depth = 1.0; // mm
constexpr double Poisson = 0.4;

/// A body under a sphere, in a window with the panel on the right.
struct Window
{
  Picture picture{ 1000, 760 };
  vtkSmartPointer<vtkRenderer> left = picture.addRenderer(0.0, 0.75);
  vtkSmartPointer<vtkRenderer> right = picture.addRenderer(0.75, 1.0);
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkContactSetup> setup;
  vtkNew<vtkContactScene> scene;
  vtkNew<vtkHapticSession> session;
  vtkNew<vtkFrameClock> clock;
  vtkNew<vtkSessionFiles> files;
  vtkNew<vtkInteractorStyleHaptic> style;
  vtkNew<vtkContactPanel> panel;

  /// With `scanned`, responses of a layer differ from point to point, and take seconds to compute.
  explicit Window(int cells = 60, bool scanned = false)
  {
    this->interactor->SetRenderWindow(this->picture.window);
    const Body body = planeBody(15.0, cells);
    if (scanned)
    {
      pointArray(body, "LayerThickness",
        [](vtkIdType i) { return 8.0 + 3.0 * std::sin(static_cast<double>(i)); });
    }
    this->setup->SetBody(body);
    this->setup->AddTool(makeTool("sphere:5"));
    this->setup->AddTool(makeTool("flat:1"));
    this->setup->AddTool(makeTool("cone:60"));
    this->setup->SetYoungsModulus(0.05);
    this->setup->SetPoissonRatio(Poisson);
    this->setup->SetLayerThickness(scanned ? 0.0 : 8.0);
    PALPATE_CHECK(this->setup->Update());
    this->scene->SetRenderer(this->left);
    this->setup->ShowIn(this->scene);
    this->session->RealTimeOn();
    this->session->GetRecorder()->RecordingOff();
    this->session->GetRecorder()->SetHistorySeconds(5.0);
    PALPATE_CHECK(this->setup->ApplyTo(this->session));
    this->style->SetSession(this->session);
    this->style->SetScene(this->scene);
    this->style->SetFiles(this->files);
    this->files->SetSession(this->session);
    this->files->SetWindow(this->picture.window);
    this->clock->SetInteractor(this->interactor);
    this->scene->Follow(this->clock, this->session);
    this->interactor->SetInteractorStyle(this->style);
    const double tip[3] = { 0.3, 0.2, -Depth };
    const double up[3] = { 0.0, 0.0, 1.0 };
    const double above[3] = { 0.3, 0.2, 5.0 };
    this->session->GetDevice()->SteerTo(above);
    PALPATE_CHECK(this->session->Start());
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    this->session->GetDevice()->SteerTo(tip);
    this->scene->ShowContact(above, above, up, above, 0.0, -1);
    const double from[3] = { 0.0, -1.0, 0.5 };
    this->scene->LookAtContact(80.0, from, up);
    this->picture.window->Render();
    this->panel->SetRenderer(this->right);
    this->panel->SetSetup(this->setup);
    this->panel->SetStyle(this->style);
    this->panel->SetClock(this->clock);
    this->panel->On();
    this->clock->ShowFrame();
  }

  void send(unsigned long event, const int position[2])
  {
    this->interactor->SetEventInformation(position[0], position[1]);
    this->interactor->InvokeEvent(event);
  }
  void press(const std::string& label)
  {
    int place[2];
    PALPATE_CHECK(this->panel->FindButton(label, place));
    this->send(vtkCommand::MouseMoveEvent, place);
    this->send(vtkCommand::LeftButtonPressEvent, place);
    this->send(vtkCommand::LeftButtonReleaseEvent, place);
    this->settle();
  }
  /// Drags the handle from one value to another, in three moves.
  void drag(const std::string& name, double from, double to)
  {
    int start[2];
    int end[2];
    PALPATE_CHECK(this->panel->FindSlider(name, from, start));
    PALPATE_CHECK(this->panel->FindSlider(name, to, end));
    this->send(vtkCommand::MouseMoveEvent, start);
    this->send(vtkCommand::LeftButtonPressEvent, start);
    for (int step = 1; step <= 3; ++step)
    {
      const int place[2] = { start[0] + step * (end[0] - start[0]) / 3, start[1] + step };
      this->send(vtkCommand::MouseMoveEvent, place);
      this->clock->ShowFrame();
    }
    this->send(vtkCommand::LeftButtonReleaseEvent, end);
    this->settle();
  }
  /// Waits until the hand is at its target, for a limited time.
  void arrive()
  {
    for (int i = 0; i < 20000 && std::abs(this->session->GetDeflection() - Depth) > 1e-7; ++i)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  /// Waits until the requested response is in use, for a limited time.
  void settle()
  {
    this->clock->ShowFrame();
    for (int i = 0; i < 20000 && this->setup->IsBusy(); ++i)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      this->panel->Update();
    }
    this->panel->Update();
    std::this_thread::sleep_for(std::chrono::milliseconds(50)); // time for the ramp of the force
    const vtkIdType ticks = this->session->GetNumberOfTicks();
    for (int i = 0; i < 20000 && this->session->GetNumberOfTicks() < ticks + 60; ++i)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    this->clock->ShowFrame();
  }
  double force()
  {
    double ideal[3];
    this->session->GetIdealForce(ideal);
    return vtkMath::Norm(ideal);
  }
  /// Force of the chosen tool on a half-space with the material of the setup.
  double expected()
  {
    const double nu = this->setup->GetPoissonRatio();
    return this->setup->GetTool(this->setup->GetChosenTool())
      ->GetForce(Depth, this->setup->GetYoungsModulus() / (1.0 - nu * nu));
  }
};

constexpr double Storage = 1e-3; // relative error of curves with eight samples

void checkMaterial(Window& w)
{
  w.arrive();
  PALPATE_CHECK_NEAR(w.session->GetDeflection(), Depth, 1e-6);
  PALPATE_CHECK_NEAR(w.force() / w.expected(), 1.0, Storage);
  const double before = w.force();
  w.drag("Young's modulus", 0.05, 2.0);
  // A pixel is 4 % of the modulus: 4 decades over 208 pixels.
  PALPATE_CHECK_NEAR(w.setup->GetYoungsModulus(), 2.0, 0.1);
  PALPATE_CHECK_NEAR(w.force() / w.expected(), 1.0, Storage);
  PALPATE_CHECK_NEAR(w.force() / before, w.setup->GetYoungsModulus() / 0.05, 0.1);
  w.drag("Poisson's ratio", Poisson, 0.1);
  PALPATE_CHECK_NEAR(w.setup->GetPoissonRatio(), 0.1, 0.01);
  PALPATE_CHECK(w.session->GetSettings()->GetPoissonRatio() == w.setup->GetPoissonRatio());
  PALPATE_CHECK_NEAR(w.force() / w.expected(), 1.0, Storage);
  w.drag("Friction", 0.0, 0.5);
  PALPATE_CHECK_NEAR(w.session->GetSettings()->GetFrictionCoefficient(), 0.5, 0.01);
  w.drag("Dent drawn deeper", 1.0, 8.0);
  PALPATE_CHECK_NEAR(w.scene->GetExaggeration(), 8.0, 0.5);
}

void checkTools(Window& w)
{
  w.drag("Radius", 5.0, 10.0);
  PALPATE_CHECK_NEAR(w.setup->GetToolInHand()->GetSize(), 10.0, 0.4);
  PALPATE_CHECK_NEAR(w.force() / w.expected(), 1.0, Storage);
  w.press("2   flat, 1 mm");
  PALPATE_CHECK(w.setup->GetChosenTool() == 1);
  PALPATE_CHECK_NEAR(w.force() / w.expected(), 1.0, Storage);
  w.interactor->SetKeyCode('3');
  w.interactor->InvokeEvent(vtkCommand::CharEvent);
  w.settle();
  PALPATE_CHECK(w.setup->GetChosenTool() == 2 && w.setup->GetToolInHand()->IsSizeAngle());
  PALPATE_CHECK_NEAR(w.force() / w.expected(), 1.0, Storage);
  w.drag("Half angle", 60.0, 45.0);
  PALPATE_CHECK_NEAR(w.setup->GetToolInHand()->GetSize(), 45.0, 1.0);
  PALPATE_CHECK_NEAR(w.force() / w.expected(), 1.0, Storage);
  int nowhere[2];
  PALPATE_CHECK(!w.panel->FindSlider("Radius", 1.0, nowhere));
  PALPATE_CHECK(!w.panel->FindButton("In series", nowhere)); // the body has no compliance
}

void checkModel(Window& w)
{
  w.press("Layer");
  PALPATE_CHECK(w.setup->GetModel() == vtkContactSetup::Layer);
  // A rigid base at a small depth increases the stiffness.
  PALPATE_CHECK(w.force() > 1.01 * w.expected());
  w.press("Half-space");
  PALPATE_CHECK_NEAR(w.force() / w.expected(), 1.0, Storage);
  // A program may also change the setup: the panel requests the responses, and shows the value.
  w.setup->SetYoungsModulus(0.4);
  w.settle();
  PALPATE_CHECK_NEAR(w.force() / w.expected(), 1.0, Storage);
  int handle[2];
  PALPATE_CHECK(w.panel->FindSlider("Young's modulus", 0.4, handle));
  w.send(vtkCommand::LeftButtonPressEvent, handle); // pressed at its position; at most a pixel away
  w.send(vtkCommand::LeftButtonReleaseEvent, handle);
  PALPATE_CHECK_NEAR(w.setup->GetYoungsModulus(), 0.4, 0.02);
  w.settle();
}

/// The body does not relax until a strength is set. Then it relaxes with the given time.
void checkRelaxation(Window& w)
{
  int nowhere[2];
  PALPATE_CHECK(!w.panel->FindSlider("Relaxation time", 1.0, nowhere));
  w.drag("Relaxation", 0.0, 1.0);
  PALPATE_CHECK(w.setup->GetNumberOfRelaxations() == 1);
  PALPATE_CHECK_NEAR(w.setup->GetRelaxationStrength(0), 1.0, 0.05);
  w.drag("Relaxation time", 1.0, 0.1);
  PALPATE_CHECK_NEAR(w.setup->GetRelaxationTime(0), 0.1, 0.01);
  // After a long press the memory is zero. After a lift, half of the force of another press is
  // initially memory.
  w.arrive();
  PALPATE_CHECK_NEAR(w.force() / w.expected(), 1.0, 0.01);
  const double above[3] = { 0.3, 0.2, 1.0 };
  const double tip[3] = { 0.3, 0.2, -Depth };
  w.session->GetDevice()->SteerTo(above);
  std::this_thread::sleep_for(std::chrono::milliseconds(1000));
  w.session->GetDevice()->SteerTo(tip);
  double most = 0.0;
  for (int i = 0; i < 500; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    most = std::max(most, w.session->GetNewestTick().contact.memory);
  }
  PALPATE_CHECK(most > 0.05 * w.expected());
  w.setup->SetRelaxation(0, 0.0, 0.1);
  w.settle();
  PALPATE_CHECK(!w.panel->FindSlider("Relaxation time", 0.1, nowhere));
}

/// The status in the panel: its text without line breaks, and its box in pixels.
std::string shownStatus(Window& w, double box[4])
{
  vtkPropCollection* props = w.right->GetViewProps();
  const auto joined = [](std::string text)
  {
    text.erase(
      std::remove_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == ' '; }),
      text.end());
    return text;
  };
  const std::string whole = joined(w.panel->GetStatus());
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    auto* text = vtkTextActor::SafeDownCast(props->GetItemAsObject(i));
    if (text && text->GetInput() && joined(text->GetInput()) == whole)
    {
      double size[4];
      text->GetBoundingBox(w.right, size);
      const double* at = text->GetPosition();
      box[0] = at[0] + size[0];
      box[1] = at[0] + size[1];
      box[2] = at[1] + size[2];
      box[3] = at[1] + size[3];
      return whole;
    }
  }
  return {};
}

/// A status that is wider than the panel, with and without blanks, is shown completely.
void checkWholeStatus(Window& w)
{
  const auto folder = std::filesystem::current_path() / "TestContactPanel";
  for (const std::string& name : { std::string("pictures of the left hand with its five fingers"),
         std::string(60, 'w'), std::string("a/longer/path/of/many/folders/for/pictures") })
  {
    std::filesystem::create_directories(folder / name);
    w.files->SetOutputFolder((folder / name).string());
    w.press("Picture");
    PALPATE_CHECK_TEXT(w.panel->GetStatus(), name.c_str(), "palpate-");
    double box[4] = { -1.0, 0.0, -1.0, 0.0 };
    PALPATE_CHECK(!shownStatus(w, box).empty());
    const int* size = w.right->GetSize();
    PALPATE_CHECK(box[0] >= 0.0 && box[1] <= size[0]);
    PALPATE_CHECK(box[2] >= 0.0 && box[3] <= size[1]);
  }
  w.files->SetOutputFolder(folder.string());
}

/// The wheel stops at the largest depth of the curves, and the status says so.
void checkGreatestDepth(Window& w)
{
  w.left->SetWorldPoint(3.0, 2.0, 0.0, 1.0);
  w.left->WorldToDisplay();
  const double* place = w.left->GetDisplayPoint();
  const int over[2] = { static_cast<int>(place[0]), static_cast<int>(place[1]) };
  w.send(vtkCommand::MouseMoveEvent, over);
  for (int notch = 0; notch < 20; ++notch)
  {
    w.send(vtkCommand::MouseWheelForwardEvent, over);
  }
  w.clock->ShowFrame();
  PALPATE_CHECK_NEAR(w.style->GetWheelDepth(), w.style->GetMaximumDepth(), 1e-9);
  PALPATE_CHECK(w.panel->GetStatus().empty()); // exactly there
  w.send(vtkCommand::MouseWheelForwardEvent, over);
  w.clock->ShowFrame();
  PALPATE_CHECK_TEXT(w.panel->GetStatus(), "the greatest depth of these curves, 2 mm");
  w.send(vtkCommand::MouseWheelBackwardEvent, over);
  w.clock->ShowFrame();
  PALPATE_CHECK(w.panel->GetStatus().empty());
}

/// While responses are computed, the button Cancel stands in the row of the status and moves no
/// other row; the caption says whose force it still shows. Leaves the picture of that state.
void checkWaiting(Window& w, const char* folder)
{
  w.press("Layer");
  w.setup->SetPoissonRatio(0.3);
  w.clock->ShowFrame(); // requests the responses; the button appears later
  int nowhere[2];
  PALPATE_CHECK(!w.panel->FindButton("Cancel", nowhere));
  const auto before = draw(w.picture.window);
  for (int i = 0; i < 20000 && !w.panel->FindButton("Cancel", nowhere); ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    w.clock->ShowFrame();
  }
  int cancel[2];
  int last[2];
  PALPATE_CHECK(w.panel->FindButton("Cancel", cancel) && w.panel->FindButton("Picture", last));
  PALPATE_CHECK(cancel[1] < last[1]);
  PALPATE_CHECK_TEXT(w.panel->GetStatus(), "computing the responses: ");
  PALPATE_CHECK_TEXT(caption(w.left), "Computing: still the force of nu = 0.4");
  const auto during = draw(w.picture.window);
  writePicture(during, std::string(folder) + "/TestContactPanel-waiting.png");
  constexpr int halfButton = 14; // pixels
  const int* size = before->GetDimensions();
  int changed = 0;
  for (int y = last[1] - halfButton; y < size[1]; ++y)
  {
    for (int x = 3 * size[0] / 4; x < size[0]; ++x)
    {
      for (int k = 0; k < 3; ++k)
      {
        changed += before->GetScalarComponentAsDouble(x, y, 0, k) !=
          during->GetScalarComponentAsDouble(x, y, 0, k);
      }
    }
  }
  PALPATE_CHECK(changed == 0);
  // The progress differs from run to run.
  vtkPropCollection* props = w.right->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    auto* text = vtkTextActor::SafeDownCast(props->GetItemAsObject(i));
    if (text && text->GetInput() && std::string(text->GetInput()).rfind("computing", 0) == 0)
    {
      text->VisibilityOff();
    }
  }
  w.left->RemoveAllViewProps();
}

void checkSession(Window& w)
{
  const auto folder = std::filesystem::current_path() / "TestContactPanel";
  std::filesystem::remove_all(folder);
  w.files->SetOutputFolder(folder.string());
  w.press("Record");
  PALPATE_CHECK(w.files->IsRecording());
  PALPATE_CHECK_TEXT(w.panel->GetStatus(), "recording", " s");
  w.press("Record");
  PALPATE_CHECK(!w.files->IsRecording() && w.files->GetNumberOfRecordedTicks() > 10);
  palpate::Trajectory record;
  PALPATE_CHECK(palpate::readTrajectory((folder / "palpate-1.csv").string(), record).empty());
  const palpate::RecordedSetup* setup = record.setups.at(0.0);
  PALPATE_CHECK(setup && (*setup)[palpate::SetupPart::Tool].rfind("cone:", 0) == 0);
  PALPATE_CHECK(setup &&
    (*setup)[palpate::SetupPart::Material] ==
      palpate::materialInWords(w.setup->GetYoungsModulus(), w.setup->GetPoissonRatio()));
  w.press("Picture");
  PALPATE_CHECK(std::filesystem::exists(folder / "palpate-1.png"));
  checkWholeStatus(w);
  w.press("Keys: ?");
  PALPATE_CHECK(w.style->GetHelpVisibility());
  w.press("Keys: ?");
  w.press("Stop");
  PALPATE_CHECK(w.session->GetState() == vtkHapticSession::Stopped);
}
} // namespace

int TestContactPanel(int argc, char* argv[])
{
  vtkNew<vtkTesting> arguments;
  arguments->AddArguments(argc, argv);
  Window window;
  checkMaterial(window);
  checkTools(window);
  checkModel(window);
  checkRelaxation(window);
  checkGreatestDepth(window);
  checkSession(window);
  // The picture contains the panel only, while it waits; other tests cover the scene.
  Window waiting(120, true);
  waiting.setup->SetYoungsModulus(0.035);
  waiting.setup->SetRelaxation(0, 0.5, 0.2);
  waiting.setup->SetChosenTool(0);
  waiting.setup->GetToolInHand()->SetSize(6.35);
  waiting.session->GetSettings()->SetFrictionCoefficient(0.3);
  waiting.settle();
  checkWaiting(waiting, arguments->GetTempDirectory());
  checkBaseline(waiting.picture.window, argc, argv);
  return palpate::testing::result();
}
