// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/SceneLegends.h"

#include "Interaction/Display/ColorLegend.h"
#include "Interaction/Display/DisplayColors.h"

#include "vtkCoordinate.h"
#include "vtkLookupTable.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr int LegendSize = 15;
constexpr double LegendWidth = 175.0;   // pixels
constexpr double CaptionHeight = 160.0; // pixels free below the legends, so that they stay put
constexpr double LegendBottom = 0.15;
constexpr double LegendTop = 0.97;
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
