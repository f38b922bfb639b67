// SPDX-License-Identifier: BSD-3-Clause
// The keys of vtkInteractorStyleHaptic, and their help text.
#include "vtkInteractorStyleHaptic.h"

#include "Interaction/Panel/KeyHelp.h"
#include "Interaction/Panel/SteeredHand.h"
#include "vtkContactScene.h"
#include "vtkHapticDevice.h"
#include "vtkHapticSession.h"
#include "vtkSessionFiles.h"

#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <map>

namespace
{
constexpr double LargestExaggeration = 64.0;

const std::map<char, unsigned long> KeyEvents = { { ' ', vtkInteractorStyleHaptic::SwitchEvent },
  { 'c', vtkInteractorStyleHaptic::CompareEvent }, { 'g', vtkInteractorStyleHaptic::ChartsEvent },
  { 't', vtkInteractorStyleHaptic::HistogramEvent } };
} // namespace

/// Returns the text for KeyHelp, which lists the functions of mouse and keys.
const char* vtkInteractorStyleHaptic::OwnKeys()
{
  return "? or h\tthis help, on and off\n"
         "\n"
         "mouse on the body\tthe tool hovers under the pointer\n"
         "left button\tpress and slide\n"
         "wheel\tpress deeper, or less deep\n"
         "left beside the body\torbit\n"
         "middle, right\tpan, zoom\n"
         "Ctrl + wheel\tzoom\n"
         "\n"
         "Shift + wheel\tthe tool leans to the right, or left\n"
         "[ ]  { }\tleans left, right; towards you, away\n"
         "0\tit stands upright\n"
         "\n"
         "1 to 9\tchoose the tool\n"
         "n\tmove the next of several hands\n"
         "v\tthe pointer moves the tool in the plane of the view\n"
         "+  -\tdraw the dent deeper, less deep than it is\n"
         "c\tcompare the tools\n"
         "g  t\tcharts; how the servo thread keeps time\n"
         "x\tstop and start the session\n"
         "k\tkeep a record; write it\n"
         "p\twrite a picture of the window\n"
         "r\tback to the first view\n"
         "q\tquit";
}

void vtkInteractorStyleHaptic::OnChar()
{
  if (!this->DoKey(this->Interactor->GetKeyCode()))
  {
    this->Superclass::OnChar();
  }
}

/// Handles a key. Returns false for a key that the superclass handles.
bool vtkInteractorStyleHaptic::DoKey(char key)
{
  if (key >= '1' && key <= '9')
  {
    int tool = key - '1';
    this->InvokeEvent(ToolChosenEvent, &tool);
    return true;
  }
  if (const auto found = KeyEvents.find(key); found != KeyEvents.end())
  {
    this->InvokeEvent(found->second);
    return true;
  }
  // X reports the key without Shift. On an American keyboard, ? is on the key / and + is on the key
  // =.
  using Style = vtkInteractorStyleHaptic;
  static const std::map<char, void (*)(Style&)> actions = {
    { '?', [](Style& style) { style.SetHelpVisibility(!style.GetHelpVisibility()); } },
    { '[', [](Style& style) { style.Lean(-palpate::SteeredTilt::PerNotch, 0.0); } },
    { ']', [](Style& style) { style.Lean(palpate::SteeredTilt::PerNotch, 0.0); } },
    { '{', [](Style& style) { style.Lean(0.0, -palpate::SteeredTilt::PerNotch); } },
    { '}', [](Style& style) { style.Lean(0.0, palpate::SteeredTilt::PerNotch); } },
    { '0',
      [](Style& style)
      {
        const palpate::SteeredTilt& tilt = style.Steered().tilt;
        style.Lean(-tilt.right(), -tilt.away());
      } },
    { 'n', [](Style& style) { style.TakeNextHand(); } },
    { 'v',
      [](Style& style) { style.SetSteering(style.Steering == Surface ? ViewPlane : Surface); } },
    { '+', [](Style& style) { style.Exaggerate(2.0); } },
    { '-', [](Style& style) { style.Exaggerate(0.5); } },
    { 'x',
      [](Style& style)
      {
        if (style.Session)
        {
          style.Session->Toggle();
        }
      } },
    { 'k',
      [](Style& style)
      {
        if (style.Files)
        {
          style.Files->ToggleRecording();
        }
      } },
    { 'p',
      [](Style& style)
      {
        if (style.Files)
        {
          style.Files->WritePicture();
        }
      } },
    { 'r',
      [](Style& style)
      {
        if (style.Scene)
        {
          style.Scene->ResetView();
        }
      } },
  };
  static const std::map<char, char> sameAs = { { '/', '?' }, { 'h', '?' }, { '=', '+' } };
  const auto same = sameAs.find(key);
  const auto action = actions.find(same == sameAs.end() ? key : same->second);
  if (action == actions.end())
  {
    return false;
  }
  action->second(*this);
  return true;
}

/// Changes to the next hand that a pointer can move. No change if there is no other such hand.
void vtkInteractorStyleHaptic::TakeNextHand()
{
  const int count = this->Session ? this->Session->GetNumberOfDevices() : 1;
  for (int step = 1; step < count; ++step)
  {
    const int next = (this->Hand + step) % count;
    if (this->Session->GetDevice(next)->IsSimulated())
    {
      this->SetHand(next);
      return;
    }
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
  this->Modified();
}

std::string vtkInteractorStyleHaptic::GetKeyHelp() const
{
  return this->Help->text();
}

void vtkInteractorStyleHaptic::Exaggerate(double factor)
{
  if (this->Scene)
  {
    this->Scene->SetExaggeration(
      std::clamp(factor * this->Scene->GetExaggeration(), 1.0, LargestExaggeration));
  }
}
