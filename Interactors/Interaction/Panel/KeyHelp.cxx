// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Panel/KeyHelp.h"

#include "Interaction/Display/DisplayColors.h"

#include "vtkActor2D.h"
#include "vtkCommand.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <sstream>
#include <utility>

namespace palpate
{
namespace
{
constexpr int KeyFontSize = 15;
constexpr int SmallestFontSize = 9;
constexpr double LineSpacing = 1.3;
constexpr int TextMargin = 22; // pixels, around the text
constexpr int Gap = 28;        // pixels, between the columns
constexpr int TopLayer = 5;
constexpr Color KeyColor = { 0.00, 0.36, 0.58 };

} // namespace

KeyHelp::KeyHelp()
  : Keys(vtkSmartPointer<vtkTextActor>::New())
  , Meanings(vtkSmartPointer<vtkTextActor>::New())
{
  this->Sheet.setColors({ 1.0, 1.0, 1.0 }, { 0.6, 0.62, 0.65 });
  this->Sheet.setOpacity(0.94);
  this->Sheet.fill()->SetLayerNumber(TopLayer);
  this->Sheet.outline()->SetLayerNumber(TopLayer);
  for (vtkTextActor* actor : { this->Keys.Get(), this->Meanings.Get() })
  {
    actor->SetLayerNumber(TopLayer);
    vtkTextProperty* look = actor->GetTextProperty();
    look->SetFontSize(KeyFontSize);
    look->SetLineSpacing(LineSpacing);
    look->SetColor(TextColor.data());
    look->SetVerticalJustificationToTop();
  }
  this->Keys->GetTextProperty()->SetColor(KeyColor.data());
  // In VTK's proportional font, [ ] look like ( ).
  this->Keys->GetTextProperty()->SetFontFamilyToCourier();
  this->Keys->GetTextProperty()->SetBold(1);
}

KeyHelp::~KeyHelp()
{
  this->show(nullptr);
}

void KeyHelp::setText(const std::string& text)
{
  this->Text = text;
  std::string keys;
  std::string meanings;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t tab = line.find('\t');
    keys += (tab == std::string::npos ? line : line.substr(0, tab)) + "\n";
    meanings += (tab == std::string::npos ? "" : line.substr(tab + 1)) + "\n";
  }
  const auto withoutEnd = [](std::string& lineList)
  { lineList.erase(std::min(lineList.find_last_not_of('\n') + 1, lineList.size())); };
  withoutEnd(keys);
  withoutEnd(meanings);
  this->Keys->SetInput(keys.c_str());
  this->Meanings->SetInput(meanings.c_str());
}

void KeyHelp::show(vtkRenderer* renderer)
{
  const std::initializer_list<vtkProp*> props = { this->Sheet.fill(), this->Sheet.outline(),
    this->Keys.Get(), this->Meanings.Get() };
  for (vtkProp* prop : props)
  {
    if (this->Renderer)
    {
      this->Renderer->RemoveViewProp(prop);
    }
    if (renderer)
    {
      renderer->AddViewProp(prop);
    }
  }
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this->Observer);
  }
  if (renderer)
  {
    this->Observer = renderer->AddObserver(vtkCommand::StartEvent, this, &KeyHelp::place);
  }
  this->Renderer = renderer;
}

void KeyHelp::place()
{
  if (!this->Renderer || !this->Renderer->GetVTKWindow())
  {
    return;
  }
  const int* size = this->Renderer->GetSize();
  double keys[2];
  double meanings[2];
  const auto measure = [&](int fontSize)
  {
    this->Keys->GetTextProperty()->SetFontSize(fontSize);
    this->Meanings->GetTextProperty()->SetFontSize(fontSize);
    this->Meanings->GetSize(this->Renderer, meanings);
    // The lines of both columns must be at equal heights although the heights of their fonts
    // differ.
    double spacing = LineSpacing;
    for (int i = 0; i < 3; ++i)
    {
      this->Keys->GetTextProperty()->SetLineSpacing(spacing);
      this->Keys->GetSize(this->Renderer, keys);
      spacing *= keys[1] > 0.0 ? meanings[1] / keys[1] : 1.0;
    }
    return std::pair(keys[0] + Gap + meanings[0] + 2 * TextMargin,
      std::max(keys[1], meanings[1]) + 2 * TextMargin);
  };
  auto sheet = measure(KeyFontSize);
  const double share = std::min(size[0] / sheet.first, size[1] / sheet.second);
  if (share < 1.0)
  {
    sheet = measure(std::max(static_cast<int>(share * KeyFontSize), SmallestFontSize));
  }
  const double left = std::floor(0.5 * (size[0] - sheet.first));
  const double bottom = std::floor(0.5 * (size[1] - sheet.second));
  this->Sheet.place(left, bottom, sheet.first, sheet.second);
  const double top = bottom + sheet.second - TextMargin;
  this->Keys->SetPosition(left + TextMargin, top);
  this->Meanings->SetPosition(left + TextMargin + keys[0] + Gap, top);
}
} // namespace palpate
