// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Panel/PanelButton.h"

#include "Interaction/Panel/PanelLook.h"

#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr double LeftMargin = 10.0; // left margin of a label that is aligned left, pixels
}

PanelButton::PanelButton()
{
  // One state, because the owner, not the widget, switches the button on and off.
  this->NumberOfStates = 1;
  stylePanelText(this->Text, TextColor);
  this->Text->GetTextProperty()->SetJustificationToCentered();
  this->Text->GetTextProperty()->SetVerticalJustificationToCentered();
  this->recolor();
}

void PanelButton::setLabel(const std::string& label)
{
  this->Label = label;
  this->Text->SetInput(label.c_str());
}

void PanelButton::setOn(bool on)
{
  this->On = on;
  this->recolor();
}

void PanelButton::alignLeft()
{
  this->IsLeftAligned = true;
  this->Text->GetTextProperty()->SetJustificationToLeft();
}

void PanelButton::place(double left, double bottom, double width, double height, int fontSize)
{
  this->Box.place(left, bottom, width, height);
  this->Text->GetTextProperty()->SetFontSize(fontSize);
  this->Text->SetPosition(std::round(this->IsLeftAligned ? left + LeftMargin : left + 0.5 * width),
    std::round(bottom + 0.5 * height));
}

void PanelButton::findMiddle(double position[2]) const
{
  position[0] = this->Box.left() + 0.5 * this->Box.width();
  position[1] = this->Box.bottom() + 0.5 * this->Box.height();
}

int PanelButton::ComputeInteractionState(int x, int y, int)
{
  const int* origin = this->Renderer->GetOrigin();
  this->InteractionState =
    this->GetVisibility() && this->Box.contains(x - origin[0], y - origin[1]) ? Inside : Outside;
  return this->InteractionState;
}

void PanelButton::Highlight(int state)
{
  this->HighlightState = state;
  this->recolor();
}

void PanelButton::recolor()
{
  const Color& paper = this->HighlightState == HighlightSelecting ? TrackColor
    : this->HighlightState == HighlightHovering                   ? HoverColor
                                                                  : PaperColor;
  this->Box.setColors(this->On ? AccentColor : paper, this->On ? AccentColor : OutlineColor);
  const Color& text = this->On ? PaperColor : TextColor;
  this->Text->GetTextProperty()->SetColor(text[0], text[1], text[2]);
}

template <class Do>
void PanelButton::forEachActor(const Do& act)
{
  act(this->Box.fill());
  act(this->Box.outline());
  act(this->Text.Get());
}

void PanelButton::GetActors2D(vtkPropCollection* props)
{
  this->forEachActor([props](vtkActor2D* actor) { props->AddItem(actor); });
}

void PanelButton::ReleaseGraphicsResources(vtkWindow* window)
{
  this->forEachActor([window](vtkActor2D* actor) { actor->ReleaseGraphicsResources(window); });
}

int PanelButton::RenderOpaqueGeometry(vtkViewport* viewport)
{
  int drawn = 0;
  this->forEachActor([&](vtkActor2D* actor) { drawn += actor->RenderOpaqueGeometry(viewport); });
  return drawn;
}

int PanelButton::RenderOverlay(vtkViewport* viewport)
{
  int drawn = 0;
  this->forEachActor([&](vtkActor2D* actor) { drawn += actor->RenderOverlay(viewport); });
  return drawn;
}
} // namespace palpate
