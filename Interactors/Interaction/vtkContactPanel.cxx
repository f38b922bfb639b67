// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactPanel.h"

#include "Interaction/Panel/ContactControls.h"
#include "Interaction/Panel/PanelLook.h"
#include "Interaction/Panel/PanelSheet.h"
#include "vtkContactSetup.h"
#include "vtkFrameClock.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkLiveCharts.h"

#include "vtkCallbackCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace
{
using palpate::PanelButton;
using palpate::PanelSlider;

constexpr float Priority = 1.0F; // the panel is the first observer that is called in a frame
} // namespace

struct vtkContactPanel::Parts
{
  vtkSmartPointer<vtkRenderer> renderer;
  vtkSmartPointer<vtkContactSetup> setup;
  vtkSmartPointer<vtkInteractorStyleHaptic> style;
  vtkSmartPointer<vtkFrameClock> clock;
  vtkSmartPointer<vtkLiveCharts> charts;
  vtkNew<vtkCallbackCommand> follow;

  std::unique_ptr<palpate::ContactControls> controls; ///< null before On is called
  palpate::PanelSheet sheet;
  std::vector<std::pair<palpate::ControlQuantity, PanelSlider*>> sliders;
  std::vector<std::pair<palpate::ControlButton, PanelButton*>> buttons;
};

vtkStandardNewMacro(vtkContactPanel);

vtkContactPanel::vtkContactPanel()
  : Kept(std::make_unique<Parts>())
{
  this->Kept->follow->SetClientData(this);
  this->Kept->follow->SetCallback(
    [](vtkObject*, unsigned long event, void* client, void* data)
    {
      auto* panel = static_cast<vtkContactPanel*>(client);
      switch (event)
      {
        case vtkFrameClock::FrameEvent:
          panel->Update();
          break;
        case vtkInteractorStyleHaptic::ToolChosenEvent:
          panel->ChooseTool(*static_cast<const int*>(data));
          break;
        case vtkInteractorStyleHaptic::CompareEvent:
          panel->SetCompare(!panel->GetCompare());
          break;
        case vtkInteractorStyleHaptic::ChartsEvent:
          panel->SetChartsVisibility(!panel->GetChartsVisibility());
          break;
        case vtkInteractorStyleHaptic::HistogramEvent:
          panel->Kept->controls->toggleTiming();
          break;
        default:
          break;
      }
    });
}

vtkContactPanel::~vtkContactPanel()
{
  this->Off();
}

void vtkContactPanel::SetRenderer(vtkRenderer* renderer)
{
  this->Kept->renderer = renderer;
  if (renderer)
  {
    renderer->SetBackground(palpate::PanelColor[0], palpate::PanelColor[1], palpate::PanelColor[2]);
    renderer->InteractiveOff();
  }
}

void vtkContactPanel::SetSetup(vtkContactSetup* setup)
{
  this->Kept->setup = setup;
}

void vtkContactPanel::SetStyle(vtkInteractorStyleHaptic* style)
{
  this->Kept->style = style;
}

void vtkContactPanel::SetClock(vtkFrameClock* clock)
{
  this->Kept->clock = clock;
}

void vtkContactPanel::SetCharts(vtkLiveCharts* charts)
{
  this->Kept->charts = charts;
}

void vtkContactPanel::On()
{
  Parts& kept = *this->Kept;
  if (!kept.renderer || !kept.setup || !kept.style || !kept.style->GetSession() ||
    !kept.style->GetScene() || !kept.style->GetInteractor() || !kept.setup->GetOutput())
  {
    vtkErrorMacro(<< "A panel needs a renderer, a setup with an output, and a style with session, "
                  << "scene and interactor.");
    return;
  }
  this->Off();
  const bool compared = this->GetCompare();
  const bool hadCharts = this->GetChartsVisibility();
  kept.controls = std::make_unique<palpate::ContactControls>(kept.setup, kept.style, kept.charts,
    [this](int tool) { this->InvokeEvent(ToolShownEvent, &tool); });
  kept.controls->setCompares(compared);
  kept.controls->setShowsCharts(hadCharts);
  this->MakeControls();
  kept.sheet.show(kept.renderer, kept.style->GetInteractor());
  for (const unsigned long event :
    { vtkInteractorStyleHaptic::ToolChosenEvent, vtkInteractorStyleHaptic::CompareEvent,
      vtkInteractorStyleHaptic::ChartsEvent, vtkInteractorStyleHaptic::HistogramEvent })
  {
    kept.style->AddObserver(event, kept.follow, Priority);
  }
  if (kept.clock)
  {
    kept.clock->AddObserver(vtkFrameClock::FrameEvent, kept.follow, Priority);
  }
  this->ShowValues();
  kept.sheet.place();
}

void vtkContactPanel::Off()
{
  Parts& kept = *this->Kept;
  if (kept.style)
  {
    kept.style->RemoveObserver(kept.follow);
  }
  if (kept.clock)
  {
    kept.clock->RemoveObserver(kept.follow);
  }
  kept.sheet.clear();
  kept.sliders.clear();
  kept.buttons.clear();
}

void vtkContactPanel::MakeControls()
{
  Parts& kept = *this->Kept;
  for (palpate::ControlRow& row : kept.controls->rows())
  {
    if (const auto* heading = std::get_if<std::string>(&row))
    {
      kept.sheet.addHeading(*heading);
    }
    else if (auto* quantity = std::get_if<palpate::ControlQuantity>(&row))
    {
      const std::size_t index = kept.sliders.size();
      const auto change = [&kept, index]
      {
        const auto& [changed, slider] = kept.sliders[index];
        if (slider->isHeld())
        {
          changed.change(slider->quantity());
        }
      };
      const auto release = [&kept, setsForces = quantity->setsForces]
      {
        if (setsForces)
        {
          kept.controls->fitScales();
        }
      };
      PanelSlider* slider = kept.sheet.addSlider(change, release);
      slider->setMeaning(quantity->name, quantity->scale, quantity->write);
      kept.sliders.emplace_back(std::move(*quantity), slider);
    }
    else if (auto* buttons = std::get_if<std::vector<palpate::ControlButton>>(&row))
    {
      for (palpate::ControlButton& button : *buttons)
      {
        PanelButton* made =
          kept.sheet.addButton(button.label(), button.press, static_cast<int>(buttons->size()));
        kept.buttons.emplace_back(std::move(button), made);
      }
    }
    else
    {
      kept.sheet.addStatus();
    }
  }
}

void vtkContactPanel::Update()
{
  Parts& kept = *this->Kept;
  if (!kept.sheet.isShown())
  {
    return;
  }
  // The force scales do not change while a slider is held, so that the change of the force is
  // visible.
  const bool isNew = kept.controls->update();
  if (isNew &&
    std::none_of(kept.sliders.begin(), kept.sliders.end(),
      [](const auto& each) { return each.first.setsForces && each.second->isHeld(); }))
  {
    kept.controls->fitScales();
  }
  this->ShowValues();
  kept.sheet.setStatus(kept.controls->status());
  kept.sheet.place();
}

void vtkContactPanel::ShowValues()
{
  for (const auto& [quantity, slider] : this->Kept->sliders)
  {
    slider->SetVisibility(quantity.isOffered());
    slider->setQuantity(quantity.read());
  }
  for (const auto& [button, shown] : this->Kept->buttons)
  {
    shown->SetVisibility(button.isOffered());
    shown->setLabel(button.label());
    shown->setOn(button.isOn());
  }
}

void vtkContactPanel::ChooseTool(int tool)
{
  if (this->Kept->controls)
  {
    this->Kept->controls->chooseTool(tool);
  }
}

void vtkContactPanel::SetCompare(bool compare)
{
  if (this->Kept->controls && compare != this->GetCompare())
  {
    this->Kept->controls->setCompares(compare);
    this->Modified();
  }
}

bool vtkContactPanel::GetCompare()
{
  return this->Kept->controls && this->Kept->controls->compares();
}

void vtkContactPanel::SetChartsVisibility(bool visible)
{
  if (this->Kept->controls && visible != this->GetChartsVisibility())
  {
    this->Kept->controls->setShowsCharts(visible);
    this->Modified();
  }
}

bool vtkContactPanel::GetChartsVisibility()
{
  return !this->Kept->controls || this->Kept->controls->showsCharts();
}

bool vtkContactPanel::FindButton(const std::string& label, int position[2])
{
  for (const auto& button : this->Kept->sheet.buttons())
  {
    if (button->GetVisibility() && button->label() == label)
    {
      double middle[2];
      button->findMiddle(middle);
      const int* origin = this->Kept->renderer->GetOrigin();
      position[0] = origin[0] + static_cast<int>(middle[0]);
      position[1] = origin[1] + static_cast<int>(middle[1]);
      return true;
    }
  }
  return false;
}

bool vtkContactPanel::FindSlider(const std::string& name, double value, int position[2])
{
  for (const auto& slider : this->Kept->sheet.sliders())
  {
    if (slider->GetVisibility() && slider->name() == name)
    {
      double handle[2];
      slider->findHandle(value, handle);
      const int* origin = this->Kept->renderer->GetOrigin();
      position[0] = origin[0] + static_cast<int>(handle[0] + 0.5);
      position[1] = origin[1] + static_cast<int>(handle[1]);
      return true;
    }
  }
  return false;
}

std::string vtkContactPanel::GetStatus()
{
  return this->Kept->sheet.status();
}

void vtkContactPanel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Compare: " << this->GetCompare() << "\n";
  os << indent << "ChartsVisibility: " << this->GetChartsVisibility() << "\n";
  os << indent << "Status: " << this->GetStatus() << "\n";
}
