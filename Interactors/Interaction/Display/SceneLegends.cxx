// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/SceneLegends.h"

#include "Interaction/Display/DisplayColors.h"

#include "vtkCoordinate.h"
#include "vtkLookupTable.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <string>

namespace palpate
{
namespace
{
constexpr int LegendSize = 15;
constexpr double LegendWidth = 175.0;   // pixels
constexpr double CaptionHeight = 160.0; // pixels free below the legends, so that they stay put
constexpr double LegendBottom = 0.15;
constexpr double LegendTop = 0.97;

/// The colours, blended.
void fillColors(vtkLookupTable* table, const std::array<Color, 5>& colors)
{
  constexpr int size = 256;
  const double last = static_cast<double>(colors.size()) - 1.0;
  table->SetNumberOfTableValues(size);
  for (int i = 0; i < size; ++i)
  {
    const double position = last * i / (size - 1);
    const auto left = static_cast<std::size_t>(std::min(position, last - 1.0));
    const double share = position - static_cast<double>(left);
    Color color{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      color[k] = (1.0 - share) * colors[left][k] + share * colors[left + 1][k];
    }
    table->SetTableValue(i, color[0], color[1], color[2]);
  }
}

/// A slim bar with its title and five numbers, `fontSize` points.
void styleLegend(vtkScalarBarActor* legend, vtkLookupTable* table, const char* title, int fontSize)
{
  legend->SetLookupTable(table);
  legend->SetTitle((std::string(title) + "\n ").c_str()); // a line of air above the bar
  legend->SetNumberOfLabels(5);
  legend->SetLabelFormat("%.2f");
  legend->SetBarRatio(0.25);
  legend->UnconstrainedFontSizeOn();
  legend->SetHeight(0.5);
  for (vtkTextProperty* text : { legend->GetTitleTextProperty(), legend->GetLabelTextProperty() })
  {
    text->SetColor(TextColor.data());
    text->SetFontSize(fontSize);
    text->SetBold(0);
    text->SetItalic(0);
    text->SetShadow(0);
  }
}
} // namespace

SceneLegends::SceneLegends()
{
  fillColors(this->DisplacementColors, DeflectionColors);
  this->DisplacementColors->SetVectorModeToMagnitude();
  fillColors(this->ForceColors, TrailColors);
  styleLegend(this->Displacement, this->DisplacementColors, "Displacement (mm)", LegendSize);
  styleLegend(this->Force, this->ForceColors, "Force (N)", LegendSize);
  this->Force->SetLabelFormat("%.4g");
}

SceneLegends::~SceneLegends() = default;

double SceneLegends::share(vtkRenderer* renderer)
{
  // The same size in pixels, however narrow the viewport.
  const int width = renderer ? std::max(renderer->GetSize()[0], 1) : 1;
  return std::min(1.0, LegendWidth / static_cast<double>(width));
}

void SceneLegends::place(vtkRenderer* renderer, double captionHeight)
{
  const double width = SceneLegends::share(renderer);
  const double reserved = std::max(CaptionHeight, captionHeight);
  const int height = std::max(renderer->GetSize()[1], 1);
  const double low = std::min(std::max(reserved / height, LegendBottom), 0.4);
  const auto place = [width](vtkScalarBarActor* legend, double bottom, double top)
  {
    legend->GetPositionCoordinate()->SetValue(1.0 - width, bottom);
    legend->SetWidth(0.85 * width);
    legend->SetHeight(top - bottom);
  };
  if (this->Force->GetVisibility())
  {
    const double middle = 0.5 * (low + LegendTop);
    place(this->Force, low, middle - 0.02);
    place(this->Displacement, middle + 0.02, LegendTop);
  }
  else
  {
    const double bottom = std::max(low, 0.25);
    place(this->Displacement, bottom, bottom + 0.5);
  }
}
} // namespace palpate
