// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Panel/PanelSheet.h"

#include "Interaction/Panel/PanelLook.h"

#include "vtkCallbackCommand.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Lengths in pixels, for a sheet with enough space.
constexpr double Width = 240.0;
constexpr double Margin = 16.0;
constexpr double HeadingHeight = 40.0;
constexpr double SliderHeight = 48.0;
constexpr double ButtonHeight = 32.0;
constexpr double ButtonGap = 5.0;
constexpr double StatusHeight = 58.0; // smallest height
constexpr double StatusGap = 12.0;    // above the status
constexpr double StatusMargin = 24.0; // above and below the status
constexpr int FontSize = 14;
constexpr int HeadingSize = 13;
constexpr int SmallestSize = 8;

/// Breaks a text into lines for which `fits` is true. A line is broken at a blank; if it has none,
/// after a slash; if it has none either, between any two characters (UTF-8).
std::string broken(const std::string& text, const std::function<bool(const std::string&)>& fits)
{
  constexpr std::size_t none = std::string::npos;
  std::string done;
  std::string line;
  for (std::size_t i = 0; i < text.size();)
  {
    std::size_t next = i + 1;
    while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xC0U) == 0x80U)
    {
      ++next;
    }
    const std::string letter = text.substr(i, next - i);
    i = next;
    if (letter == "\n")
    {
      done += line + letter;
      line.clear();
      continue;
    }
    if (line.empty() || fits(line + letter))
    {
      line += letter;
      continue;
    }
    const std::size_t blank = line.rfind(' ');
    const std::size_t slash = line.rfind('/');
    const std::size_t end = letter == " " ? line.size()
      : blank != none                     ? blank
      : slash != none                     ? slash + 1
                                          : line.size();
    done += line.substr(0, end) + "\n";
    line = line.substr(end) + letter;
    line.erase(0, line.front() == ' ' ? 1 : 0);
  }
  return done + line;
}
} // namespace

PanelSheet::PanelSheet()
{
  stylePanelText(this->Status, HeadingColor);
  this->Status->GetTextProperty()->SetVerticalJustificationToTop();
}

PanelSheet::~PanelSheet()
{
  this->hide();
}

bool PanelSheet::Row::isShown() const
{
  return (this->text && this->text->GetVisibility()) ||
    (this->slider && this->slider->GetVisibility()) ||
    std::any_of(this->buttons.begin(), this->buttons.end(),
      [](const auto& button) { return button->GetVisibility(); });
}

void PanelSheet::addHeading(const std::string& text)
{
  Row row;
  row.text = vtkSmartPointer<vtkTextActor>::New();
  row.text->SetInput(text.c_str());
  stylePanelText(row.text, HeadingColor);
  row.text->GetTextProperty()->SetBold(1);
  row.height = HeadingHeight;
  this->Rows.push_back(row);
}

PanelSlider* PanelSheet::addSlider(Action changed, Action released)
{
  Row row;
  row.slider = vtkSmartPointer<PanelSlider>::New();
  row.height = SliderHeight;
  vtkNew<vtkSliderWidget> widget;
  widget->SetRepresentation(row.slider);
  widget->SetAnimationModeToJump();
  this->observe(widget, vtkCommand::StartInteractionEvent, changed);
  this->observe(widget, vtkCommand::InteractionEvent, changed);
  PanelSlider* slider = row.slider;
  this->observe(widget, vtkCommand::EndInteractionEvent,
    [slider, released]
    {
      slider->release();
      released();
    });
  this->Widgets.emplace_back(widget);
  this->Sliders.push_back(row.slider);
  this->Rows.push_back(row);
  return slider;
}

PanelButton* PanelSheet::addButton(const std::string& label, Action pressed, int inRow)
{
  const auto button = vtkSmartPointer<PanelButton>::New();
  button->setLabel(label);
  vtkNew<vtkButtonWidget> widget;
  widget->SetRepresentation(button);
  this->observe(widget, vtkCommand::StateChangedEvent, pressed);
  this->Widgets.emplace_back(widget);
  this->Buttons.push_back(button);
  if (this->Rows.empty() || this->Rows.back().buttons.empty() ||
    this->Rows.back().columns != inRow ||
    static_cast<int>(this->Rows.back().buttons.size()) == inRow)
  {
    Row row;
    row.columns = inRow;
    row.height = ButtonHeight;
    row.isOnStatus = !this->Rows.empty() && this->Rows.back().text == this->Status.Get();
    this->Rows.push_back(row);
  }
  if (inRow == 1)
  {
    button->alignLeft();
  }
  this->Rows.back().buttons.push_back(button);
  return button;
}

void PanelSheet::addStatus()
{
  Row row;
  row.text = this->Status.Get();
  row.height = StatusHeight;
  this->Rows.push_back(row);
}

void PanelSheet::clear()
{
  this->hide();
  this->Rows.clear();
  this->Sliders.clear();
  this->Buttons.clear();
  this->Widgets.clear();
  this->Actions.clear();
}

void PanelSheet::breakStatus(double width, int fontSize, BrokenText& made)
{
  if (this->StatusText == made.text && width == made.width && fontSize == made.fontSize)
  {
    return;
  }
  this->Status->GetTextProperty()->SetFontSize(fontSize);
  double size[2] = { 0.0, 0.0 };
  const auto fits = [&](const std::string& line)
  {
    this->Status->SetInput(line.c_str());
    this->Status->GetSize(this->Renderer, size);
    return size[0] <= width;
  };
  const std::string lines = broken(this->StatusText, fits);
  fits(lines);
  made = { this->StatusText, width, fontSize, lines, lines.empty() ? 0.0 : size[1] };
}

void PanelSheet::show(vtkRenderer* renderer, vtkRenderWindowInteractor* interactor)
{
  this->hide();
  this->Renderer = renderer;
  for (const auto& widget : this->Widgets)
  {
    widget->SetInteractor(interactor);
    widget->SetDefaultRenderer(renderer);
    widget->SetCurrentRenderer(renderer);
    widget->On();
  }
  for (const Row& row : this->Rows)
  {
    if (row.text)
    {
      renderer->AddViewProp(row.text);
    }
  }
  this->place();
}

void PanelSheet::hide()
{
  if (!this->Renderer)
  {
    return;
  }
  for (const auto& widget : this->Widgets)
  {
    widget->Off();
    widget->SetInteractor(nullptr);
  }
  for (const Row& row : this->Rows)
  {
    if (row.text)
    {
      this->Renderer->RemoveViewProp(row.text);
    }
  }
  this->Renderer = nullptr;
}

void PanelSheet::place()
{
  if (!this->Renderer || !this->Renderer->GetVTKWindow())
  {
    return;
  }
  const int* size = this->Renderer->GetSize();
  // The status gets space for all its lines first. Then the heights of the other rows are reduced
  // if necessary.
  this->breakStatus(Width - 2.0 * Margin, FontSize - 1, this->FullSize);
  for (Row& row : this->Rows)
  {
    if (row.text == this->Status.Get())
    {
      row.height = std::max(StatusHeight, this->FullSize.height + StatusMargin);
    }
  }
  double needed = Margin;
  for (const Row& row : this->Rows)
  {
    needed += row.hasPlace() ? row.height : 0.0;
  }
  const double share = std::min({ 1.0, size[0] / Width, size[1] / needed });
  const double left = std::round(share * Margin);
  const double width = size[0] - 2.0 * left;
  const int fontSize = std::max(static_cast<int>(share * FontSize), SmallestSize);
  this->breakStatus(width, fontSize - 1, this->ShownSize);
  this->Status->SetInput(this->ShownSize.lines.c_str());
  double top = size[1];
  for (Row& row : this->Rows)
  {
    if (!row.isShown())
    {
      continue;
    }
    const double gap = std::round(share * ButtonGap);
    const double height = std::round(share * row.height);
    const double bottom = row.isOnStatus ? top - gap + 1.0 : top - height;
    if (row.text)
    {
      const bool isStatus = row.text == this->Status.Get();
      row.text->GetTextProperty()->SetFontSize(
        isStatus ? fontSize - 1 : std::max(static_cast<int>(share * HeadingSize), SmallestSize));
      row.text->SetPosition(
        left, isStatus ? top - std::round(StatusGap * share) : bottom + 7.0 * share);
    }
    if (row.slider)
    {
      row.slider->place(left, bottom, width, height, fontSize);
    }
    const double each = (width + gap) / std::max<double>(row.columns, 1.0);
    for (std::size_t i = 0; i < row.buttons.size(); ++i)
    {
      const double from = std::round(left + static_cast<double>(i) * each);
      const double to = std::round(left + static_cast<double>(i + 1) * each - gap);
      row.buttons[i]->place(from, bottom + gap, to - from, height - gap, fontSize);
    }
    top = row.isOnStatus ? top : bottom;
  }
}

void PanelSheet::observe(vtkObject* object, unsigned long event, const Action& action)
{
  this->Actions.push_back(action);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&this->Actions.back());
  command->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { (*static_cast<Action*>(data))(); });
  object->AddObserver(event, command);
}
} // namespace palpate
