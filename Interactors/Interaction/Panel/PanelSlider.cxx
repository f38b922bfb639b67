// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Panel/PanelSlider.h"

#include "Interaction/Panel/PanelLook.h"

#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double TrackHeight = 4.0;
constexpr double HandleWidth = 10.0;
constexpr double HandleHeight = 18.0;
/// Height of the middle of the track above the bottom of the row, as a fraction of the row's
/// height.
constexpr double TrackShare = 0.24;
constexpr double TextShare = 0.56;
} // namespace

PanelSlider::PanelSlider()
{
  this->Track.setColors(TrackColor, TrackColor);
  this->Filled.setColors(AccentColor, AccentColor);
  this->Handle.setColors(PaperColor, AccentColor);
  stylePanelText(this->Name, TextColor);
  stylePanelText(this->ValueText, TextColor);
  this->ValueText->GetTextProperty()->SetJustificationToRight();
}

void PanelSlider::setMeaning(const std::string& name, const PanelScale& scale, Format format)
{
  const double value = this->quantity();
  this->Title = name;
  this->Scale = scale;
  this->Write = std::move(format);
  this->Name->SetInput(name.c_str());
  this->setQuantity(value);
}

void PanelSlider::setQuantity(double value)
{
  this->Share = this->Scale.shareOf(value);
  this->ValueText->SetInput(this->Write ? this->Write(value).c_str() : "");
  this->show();
}

void PanelSlider::place(double left, double bottom, double width, double height, int fontSize)
{
  this->Row.place(left, bottom, width, height);
  this->Name->GetTextProperty()->SetFontSize(fontSize);
  this->ValueText->GetTextProperty()->SetFontSize(fontSize);
  const double text = std::round(bottom + TextShare * height);
  this->Name->SetPosition(left, text);
  this->ValueText->SetPosition(left + width, text);
  this->show();
}

void PanelSlider::findHandle(double value, double position[2]) const
{
  position[0] = this->Row.left() + 0.5 * HandleWidth +
    this->Scale.shareOf(value) * (this->Row.width() - HandleWidth);
  position[1] = this->Row.bottom() + TrackShare * this->Row.height();
}

void PanelSlider::show()
{
  const double middle = std::round(this->Row.bottom() + TrackShare * this->Row.height());
  const double reach = this->Share * (this->Row.width() - HandleWidth);
  const double left = this->Row.left();
  const double low = middle - 0.5 * TrackHeight;
  this->Track.place(left, low, this->Row.width(), TrackHeight);
  this->Filled.place(left, low, reach + 0.5 * HandleWidth, TrackHeight);
  this->Handle.place(
    std::round(left + reach), middle - 0.5 * HandleHeight, HandleWidth, HandleHeight);
}

void PanelSlider::StartWidgetInteraction(double position[2])
{
  const int* origin = this->Renderer->GetOrigin();
  this->Held =
    this->GetVisibility() && this->Row.contains(position[0] - origin[0], position[1] - origin[1]);
  this->InteractionState = this->Held ? Slider : Outside;
  if (this->Held)
  {
    this->follow(position);
  }
}

void PanelSlider::WidgetInteraction(double position[2])
{
  this->follow(position);
}

void PanelSlider::follow(const double position[2])
{
  const double along = position[0] - this->Renderer->GetOrigin()[0] - this->Row.left();
  this->Share =
    std::clamp((along - 0.5 * HandleWidth) / (this->Row.width() - HandleWidth), 0.0, 1.0);
  this->setQuantity(this->quantity());
}

template <class Do>
void PanelSlider::forEachActor(const Do& act)
{
  for (vtkActor2D* actor :
    { this->Track.fill(), this->Filled.fill(), this->Handle.fill(), this->Handle.outline() })
  {
    act(actor);
  }
  act(this->Name.Get());
  act(this->ValueText.Get());
}

void PanelSlider::GetActors2D(vtkPropCollection* props)
{
  this->forEachActor([props](vtkActor2D* actor) { props->AddItem(actor); });
}

void PanelSlider::ReleaseGraphicsResources(vtkWindow* window)
{
  this->forEachActor([window](vtkActor2D* actor) { actor->ReleaseGraphicsResources(window); });
}

int PanelSlider::RenderOpaqueGeometry(vtkViewport* viewport)
{
  int drawn = 0;
  this->forEachActor([&](vtkActor2D* actor) { drawn += actor->RenderOpaqueGeometry(viewport); });
  return drawn;
}

int PanelSlider::RenderOverlay(vtkViewport* viewport)
{
  int drawn = 0;
  this->forEachActor([&](vtkActor2D* actor) { drawn += actor->RenderOverlay(viewport); });
  return drawn;
}
} // namespace palpate
