// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInteractorStyleHaptic.h"

#include "Interaction/Panel/KeyHelp.h"
#include "Interaction/Panel/SurfacePicker.h"
#include "Interaction/Session/TickTape.h"
#include "Haptics/Devices/TrajectoryFile.h"
#include "Interaction/Display/WindowPicture.h"
#include "vtkContactScene.h"
#include "vtkHapticSession.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <filesystem>

namespace
{
constexpr double DepthPerNotch = 0.1;     // mm
constexpr unsigned long TimerPeriod = 33; // ms
constexpr double LargestExaggeration = 64.0;

const char* const Keys = "? or h\tthis help, on and off\n"
                         "\n"
                         "mouse on the body\tthe tool hovers under the pointer\n"
                         "left button\tpress and slide\n"
                         "wheel\tpress deeper, or less deep\n"
                         "left beside the body\torbit\n"
                         "middle, right\tpan, zoom\n"
                         "Ctrl + wheel\tzoom\n"
                         "\n"
                         "1 to 9\tchoose the tool\n"
                         "v\tthe pointer moves the tool in the plane of the view\n"
                         "+  -\tdraw the dent deeper, less deep than it is\n"
                         "c\tcompare the tools\n"
                         "g  t\tcharts; how the servo thread keeps time\n"
                         "x\tstop and start the session\n"
                         "k\tkeep a record; write it\n"
                         "p\twrite a picture of the window\n"
                         "r\tthe whole body in view\n"
                         "q\tquit";
} // namespace

vtkStandardNewMacro(vtkInteractorStyleHaptic);

vtkInteractorStyleHaptic::vtkInteractorStyleHaptic()
  : Picker(std::make_unique<palpate::SurfacePicker>())
  , Help(std::make_unique<palpate::KeyHelp>())
  , Tape(std::make_unique<palpate::TickTape>())
{
  this->Help->setText(Keys);
}

vtkInteractorStyleHaptic::~vtkInteractorStyleHaptic()
{
  this->StopUpdates();
}

void vtkInteractorStyleHaptic::SetSession(vtkHapticSession* session)
{
  this->Session = session;
  this->Modified();
}

void vtkInteractorStyleHaptic::SetScene(vtkContactScene* scene)
{
  this->Scene = scene;
  this->Modified();
}

vtkHapticSession* vtkInteractorStyleHaptic::GetSession()
{
  return this->Session;
}

vtkContactScene* vtkInteractorStyleHaptic::GetScene()
{
  return this->Scene;
}

void vtkInteractorStyleHaptic::SetPressDepth(double depth)
{
  this->PressDepth = std::clamp(depth, 0.0, this->MaximumDepth);
  this->Modified();
}

void vtkInteractorStyleHaptic::SetWheelDepth(double depth)
{
  constexpr double rounding = 1e-9; // of notches that add up
  this->WheelDepth = depth < rounding ? 0.0 : std::min(depth, this->MaximumDepth);
  this->Modified();
}

bool vtkInteractorStyleHaptic::StartSession()
{
  if (!this->Session || !this->Session->Start())
  {
    return false;
  }
  this->StartUpdates();
  return true;
}

void vtkInteractorStyleHaptic::StopSession()
{
  if (this->Session)
  {
    this->Session->Stop();
  }
}

void vtkInteractorStyleHaptic::ToggleSession()
{
  if (this->Session && this->Session->GetState() != vtkHapticSession::Stopped)
  {
    this->StopSession();
  }
  else
  {
    this->StartSession();
  }
}

void vtkInteractorStyleHaptic::StartUpdates()
{
  if (this->Interactor && this->Timer == 0)
  {
    this->Timer = this->Interactor->CreateRepeatingTimer(TimerPeriod);
    this->Interactor->EnableRenderOff(); // but for the frames of the timer
  }
}

void vtkInteractorStyleHaptic::StopUpdates()
{
  if (this->Interactor && this->Timer != 0)
  {
    this->Interactor->DestroyTimer(this->Timer);
    this->Interactor->EnableRenderOn();
  }
  this->Timer = 0;
}

vtkRenderer* vtkInteractorStyleHaptic::FindSceneRenderer()
{
  vtkRenderer* renderer = this->Scene ? this->Scene->GetRenderer() : nullptr;
  const int* position = this->Interactor->GetEventPosition();
  return renderer && renderer->IsInViewport(position[0], position[1]) ? renderer : nullptr;
}

bool vtkInteractorStyleHaptic::IsBesideScene()
{
  const int* position = this->Interactor->GetEventPosition();
  vtkRenderer* poked = this->Interactor->FindPokedRenderer(position[0], position[1]);
  return !poked || !poked->GetInteractive() || !poked->IsInViewport(position[0], position[1]);
}

bool vtkInteractorStyleHaptic::PickSurface(double point[3], double normal[3])
{
  vtkRenderer* renderer = this->FindSceneRenderer();
  if (!renderer || !this->Session)
  {
    return false;
  }
  this->Picker->setBody(this->Session->GetBody(), this->Session->GetResponseName());
  return this->Picker->pick(renderer, this->Interactor->GetEventPosition(), point, normal);
}

bool vtkInteractorStyleHaptic::SteerOverSurface()
{
  double point[3];
  double normal[3];
  if (!this->PickSurface(point, normal))
  {
    return false;
  }
  const double depth = this->Pressing ? this->PressDepth : this->WheelDepth;
  const double height = this->Pressing || depth > 0.0 ? -depth : this->HoverHeight;
  double tip[3];
  for (int k = 0; k < 3; ++k)
  {
    tip[k] = point[k] + height * normal[k];
  }
  std::copy_n(normal, 3, this->HoverNormal);
  this->SteerTo(tip);
  return true;
}

/// To where the line of sight under the pointer is as far away as the tip, and `away` mm farther.
bool vtkInteractorStyleHaptic::SteerInView(double away)
{
  vtkRenderer* renderer = this->FindSceneRenderer();
  if (!renderer || !this->Session)
  {
    return false;
  }
  double sight[3];
  double nearPoint[3];
  double farPoint[3];
  renderer->GetActiveCamera()->GetDirectionOfProjection(sight);
  const int* position = this->Interactor->GetEventPosition();
  palpate::worldUnder(renderer, position, 0.0, nearPoint);
  palpate::worldUnder(renderer, position, 1.0, farPoint);
  double whole[3];
  double toTip[3];
  vtkMath::Subtract(farPoint, nearPoint, whole);
  vtkMath::Subtract(this->SteeredTip, nearPoint, toTip);
  const double share = (vtkMath::Dot(toTip, sight) + away) / vtkMath::Dot(whole, sight);
  double tip[3];
  for (int k = 0; k < 3; ++k)
  {
    tip[k] = nearPoint[k] + share * whole[k];
    this->HoverNormal[k] = -sight[k];
  }
  this->SteerTo(tip);
  return true;
}

bool vtkInteractorStyleHaptic::Steer()
{
  return this->Steering == ViewPlane ? this->SteerInView(0.0) : this->SteerOverSurface();
}

void vtkInteractorStyleHaptic::HoverAt(const double point[3], const double normal[3])
{
  double tip[3];
  for (int k = 0; k < 3; ++k)
  {
    tip[k] = point[k] + this->HoverHeight * normal[k];
  }
  std::copy_n(normal, 3, this->HoverNormal);
  this->SteerTo(tip);
}

void vtkInteractorStyleHaptic::SteerTo(const double tip[3])
{
  std::copy_n(tip, 3, this->SteeredTip);
  if (this->Session)
  {
    this->Session->SteerTo(tip);
  }
  this->InvokeEvent(SteeredEvent, this->SteeredTip);
}

void vtkInteractorStyleHaptic::OnMouseMove()
{
  if (this->State == VTKIS_NONE)
  {
    this->Steer();
  }
  this->Superclass::OnMouseMove();
}

void vtkInteractorStyleHaptic::OnLeftButtonDown()
{
  this->Pressing = this->Steering == Surface;
  if (this->Pressing && this->SteerOverSurface())
  {
    return;
  }
  this->Pressing = false;
  if (!this->IsBesideScene())
  {
    this->Superclass::OnLeftButtonDown();
  }
}

void vtkInteractorStyleHaptic::OnLeftButtonUp()
{
  if (this->Pressing)
  {
    this->Pressing = false;
    this->Steer();
    return;
  }
  this->Superclass::OnLeftButtonUp();
}

void vtkInteractorStyleHaptic::OnMiddleButtonDown()
{
  if (!this->IsBesideScene())
  {
    this->Superclass::OnMiddleButtonDown();
  }
}

void vtkInteractorStyleHaptic::OnRightButtonDown()
{
  if (!this->IsBesideScene())
  {
    this->Superclass::OnRightButtonDown();
  }
}

/// False where the wheel is to zoom.
bool vtkInteractorStyleHaptic::TurnWheel(double notches)
{
  if (this->IsBesideScene())
  {
    return true;
  }
  if (this->Interactor->GetControlKey())
  {
    return false;
  }
  double point[3];
  double normal[3];
  if (this->Steering == ViewPlane)
  {
    if (!this->SteerInView(notches * DepthPerNotch))
    {
      return false;
    }
    this->WheelPressed = this->WheelPressed || notches > 0.0;
    return true;
  }
  if (!this->Pressing && !this->PickSurface(point, normal))
  {
    return false;
  }
  this->WheelPressed = this->WheelPressed || notches > 0.0;
  if (this->Pressing)
  {
    this->SetPressDepth(this->PressDepth + notches * DepthPerNotch);
  }
  else
  {
    this->SetWheelDepth(this->WheelDepth + notches * DepthPerNotch);
  }
  this->Steer();
  return true;
}

void vtkInteractorStyleHaptic::OnMouseWheelForward()
{
  if (!this->TurnWheel(1.0))
  {
    this->Superclass::OnMouseWheelForward();
  }
}

void vtkInteractorStyleHaptic::OnMouseWheelBackward()
{
  if (!this->TurnWheel(-1.0))
  {
    this->Superclass::OnMouseWheelBackward();
  }
}

void vtkInteractorStyleHaptic::OnChar()
{
  if (!this->DoKey(this->Interactor->GetKeyCode()))
  {
    this->Superclass::OnChar();
  }
}

/// False for a key that this style leaves to the one it is made of.
bool vtkInteractorStyleHaptic::DoKey(char key)
{
  if (key >= '1' && key <= '9')
  {
    int tool = key - '1';
    this->InvokeEvent(ToolChosenEvent, &tool);
    return true;
  }
  switch (key)
  {
    // X tells the key without the shift: / and = are ? and + of an American keyboard.
    case '?':
    case '/':
    case 'h':
      this->SetHelpVisibility(!this->GetHelpVisibility());
      return true;
    case ' ':
      this->InvokeEvent(SwitchEvent);
      return true;
    case 'c':
      this->InvokeEvent(CompareEvent);
      return true;
    case 'g':
      this->InvokeEvent(ChartsEvent);
      return true;
    case 't':
      this->InvokeEvent(HistogramEvent);
      return true;
    case 'v':
      this->SetSteering(this->Steering == Surface ? ViewPlane : Surface);
      return true;
    case '+':
    case '=':
      this->ExaggerateMore();
      return true;
    case '-':
      this->ExaggerateLess();
      return true;
    case 'x':
      this->ToggleSession();
      return true;
    case 'k':
      this->ToggleRecording();
      return true;
    case 'p':
      this->WritePicture();
      return true;
    case 'r':
      if (this->Scene && this->Scene->GetRenderer())
      {
        this->Scene->GetRenderer()->ResetCamera();
      }
      return true;
    default:
      return false;
  }
}

void vtkInteractorStyleHaptic::SetHelpVisibility(bool visible)
{
  this->Help->show(visible && this->Scene ? this->Scene->GetRenderer() : nullptr);
  this->Modified();
}

bool vtkInteractorStyleHaptic::GetHelpVisibility() const
{
  return this->Help->isShown();
}

void vtkInteractorStyleHaptic::SetKeyHelp(const std::string& text)
{
  this->Help->setText(text);
  this->Help->place();
  this->Modified();
}

std::string vtkInteractorStyleHaptic::GetKeyHelp() const
{
  return this->Help->text();
}

void vtkInteractorStyleHaptic::ExaggerateMore()
{
  if (this->Scene)
  {
    this->Scene->SetExaggeration(
      std::min(2.0 * this->Scene->GetExaggeration(), LargestExaggeration));
  }
}

void vtkInteractorStyleHaptic::ExaggerateLess()
{
  if (this->Scene)
  {
    this->Scene->SetExaggeration(std::max(0.5 * this->Scene->GetExaggeration(), 1.0));
  }
}

std::string vtkInteractorStyleHaptic::FreeName(const char* ending)
{
  const std::filesystem::path folder(this->OutputFolder);
  std::error_code ignored; // whoever writes the file will tell
  std::filesystem::create_directories(folder, ignored);
  std::filesystem::path name;
  const auto isTaken = [&ignored](const std::filesystem::path& path)
  {
    return std::filesystem::exists(path, ignored) ||
      std::filesystem::exists(path.string() + ".part", ignored); // what a full disk left
  };
  for (int number = 1; name.empty() || isTaken(name); ++number)
  {
    name = folder / ("palpate-" + std::to_string(number) + ending);
  }
  return name.string();
}

std::string vtkInteractorStyleHaptic::WritePicture(const std::string& fileName)
{
  vtkRenderWindow* window = this->Interactor ? this->Interactor->GetRenderWindow() : nullptr;
  if (!window)
  {
    vtkErrorMacro(<< "There is no window to write a picture of.");
    return {};
  }
  const std::string name = fileName.empty() ? this->FreeName(".png") : fileName;
  const std::string error = palpate::writeWindowPicture(window, name);
  if (!error.empty())
  {
    this->Notice = error;
    return {};
  }
  this->Notice = "picture " + name;
  return name;
}

bool vtkInteractorStyleHaptic::StartRecording()
{
  if (!this->Session || !(this->Session->GetHistorySeconds() > 0.0))
  {
    vtkErrorMacro(<< "A record is taken from the history of a session: set its HistorySeconds.");
    return false;
  }
  this->Tape->start(this->Session->GetLastTicks());
  this->Notice = "recording";
  return true;
}

std::string vtkInteractorStyleHaptic::WriteRecording(const std::string& fileName)
{
  if (!this->Tape->isRunning())
  {
    vtkErrorMacro(<< "There is no record to write: call StartRecording.");
    return {};
  }
  this->Tape->take(this->Session->GetLastTicks());
  this->Tape->stop();
  const std::string name = fileName.empty() ? this->FreeName(".csv") : fileName;
  const std::string error = palpate::writeTrajectory(name, this->Tape->ticks());
  if (!error.empty())
  {
    this->Notice = error;
    vtkErrorMacro(<< error << ".");
    return {};
  }
  this->Notice = "record " + name;
  return name;
}

bool vtkInteractorStyleHaptic::IsRecording() const
{
  return this->Tape->isRunning();
}

vtkIdType vtkInteractorStyleHaptic::GetNumberOfRecordedTicks() const
{
  return static_cast<vtkIdType>(this->Tape->ticks().size());
}

void vtkInteractorStyleHaptic::ToggleRecording()
{
  if (this->Tape->isRunning())
  {
    this->WriteRecording();
  }
  else
  {
    this->StartRecording();
  }
}

void vtkInteractorStyleHaptic::OnTimer()
{
  const auto begin = std::chrono::steady_clock::now();
  if (begin < this->NextFrame)
  {
    return;
  }
  this->ShowFrame();
  const auto end = std::chrono::steady_clock::now();
  this->NextFrame = end + (end - begin);
}

void vtkInteractorStyleHaptic::ShowFrame()
{
  if (!this->Session || !this->Scene || !this->Interactor)
  {
    return;
  }
  if (this->Tape->isRunning())
  {
    this->Tape->take(this->Session->GetLastTicks());
  }
  this->InvokeEvent(FrameEvent);
  double force[3];
  this->Session->GetIdealForce(force);
  this->StrongestForce = std::max(this->StrongestForce, vtkMath::Norm(force));
  this->Scene->ShowSession(this->Session, this->HoverNormal);
  this->Help->place();
  this->Interactor->EnableRenderOn();
  this->Interactor->Render();
  if (this->Timer != 0)
  {
    this->Interactor->EnableRenderOff();
  }
}

void vtkInteractorStyleHaptic::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Steering: " << this->Steering << "\n";
  os << indent << "PressDepth: " << this->PressDepth << " mm\n";
  os << indent << "WheelDepth: " << this->WheelDepth << " mm\n";
  os << indent << "MaximumDepth: " << this->MaximumDepth << " mm\n";
  os << indent << "HoverHeight: " << this->HoverHeight << " mm\n";
  os << indent << "StrongestForce: " << this->StrongestForce << " N\n";
  os << indent << "Pressing: " << this->Pressing << "\n";
  os << indent << "OutputFolder: " << this->OutputFolder << "\n";
  os << indent << "Notice: " << this->Notice << "\n";
}
