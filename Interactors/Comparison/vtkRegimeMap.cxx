// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRegimeMap.h"

#include "Comparison/RegimeColors.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkScalarsToColors.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>

namespace
{
constexpr int TextSize = 15;
// Width of the legend, pixels; equal to that of a contact scene.
constexpr double MapLegendWidth = 175.0;
// Shift of the legend to the left if it shows names, as a fraction of its width.
constexpr double NamesShift = 0.6;

struct QuantityLook
{
  const char* array;
  const char* title;
  const char* format;
  int labels;
  vtkSmartPointer<vtkScalarsToColors> (*colors)();
};

const std::array<QuantityLook, 3> Looks = { {
  { "RegimeIndex", "Regime index\n(lambda)\n ", "%.1f", 5, palpate::makeIndexColors },
  { "ToolSensitivity", "Size sensitivity\ndlnF/dln(size)\n ", "%.1f", 4,
    palpate::makeSensitivityColors },
  { "RegimeVerdict", "Verdict\n ", "%.0f", 0, palpate::makeVerdictColors },
} };

const QuantityLook& lookOf(int quantity)
{
  return Looks[static_cast<std::size_t>(quantity)];
}
} // namespace

vtkStandardNewMacro(vtkRegimeMap);

vtkRegimeMap::vtkRegimeMap()
  : Mapper(vtkSmartPointer<vtkPolyDataMapper>::New())
  , Actor(vtkSmartPointer<vtkActor>::New())
  , Legend(vtkSmartPointer<vtkScalarBarActor>::New())
{
  this->Mapper->SetScalarModeToUsePointFieldData();
  // Verdicts are bytes, which would otherwise be used as colours.
  this->Mapper->SetColorModeToMapScalars();
  this->Mapper->UseLookupTableScalarRangeOn();
  this->Mapper->InterpolateScalarsBeforeMappingOn(); // makes the borders between the verdicts sharp
  this->Actor->SetMapper(this->Mapper);
  // Weak shading, so that colours can be compared with the legend.
  this->Actor->GetProperty()->SetAmbient(0.55);
  this->Actor->GetProperty()->SetDiffuse(0.45);
  this->Actor->GetProperty()->SetSpecular(0.0);
  this->Legend->SetBarRatio(0.25);
  this->Legend->UnconstrainedFontSizeOn();
  this->Legend->SetHeight(0.6);
  for (vtkTextProperty* text : { this->Legend->GetTitleTextProperty(),
         this->Legend->GetLabelTextProperty(), this->Legend->GetAnnotationTextProperty() })
  {
    text->SetColor(palpate::TextColor.data());
    text->SetFontSize(TextSize);
    text->SetBold(0);
    text->SetItalic(0);
    text->SetShadow(0);
  }
  this->SetQuantity(Index);
}

vtkRegimeMap::~vtkRegimeMap() = default;

void vtkRegimeMap::SetRenderer(vtkRenderer* renderer)
{
  this->Renderer = renderer;
  renderer->AddActor(this->Actor);
  renderer->AddViewProp(this->Legend);
  this->PlaceLegend();
}

bool vtkRegimeMap::SetBody(vtkPolyData* body)
{
  for (const QuantityLook& look : Looks)
  {
    if (!body || !body->GetPointData()->GetArray(look.array))
    {
      vtkErrorMacro(<< "The body has no point array '" << look.array
                    << "': it must be the output of vtkContactRegime.");
      return false;
    }
  }
  this->Mapper->SetInputData(body);
  this->Modified();
  return true;
}

void vtkRegimeMap::SetQuantity(int quantity)
{
  this->Quantity = std::clamp<int>(quantity, Index, Verdict);
  const QuantityLook& look = lookOf(this->Quantity);
  const vtkSmartPointer<vtkScalarsToColors> colors = look.colors();
  this->Mapper->SelectColorArray(look.array);
  this->Mapper->SetLookupTable(colors);
  this->Legend->SetLookupTable(colors);
  this->Legend->SetTitle(look.title);
  this->Legend->SetLabelFormat(look.format);
  this->Legend->SetNumberOfLabels(look.labels);
  // For the verdicts, the legend shows names instead of numbers.
  const bool names = this->Quantity == Verdict;
  this->Legend->SetDrawAnnotations(names);
  this->Legend->SetDrawTickLabels(!names);
  this->Legend->SetTextPosition(
    names ? vtkScalarBarActor::PrecedeScalarBar : vtkScalarBarActor::SucceedScalarBar);
  this->PlaceLegend();
  this->Modified();
}

void vtkRegimeMap::PlaceLegend()
{
  if (this->Renderer)
  {
    // The legend has the same size in pixels, regardless of the width of the viewport.
    const double share = std::min(
      1.0, MapLegendWidth / static_cast<double>(std::max(this->Renderer->GetSize()[0], 1)));
    // The names are to the right of the bar. The shift to the left reserves space for the names.
    const double shift = this->Quantity == Verdict ? NamesShift : 0.0;
    this->Legend->GetPositionCoordinate()->SetValue(1.0 - (1.0 + shift) * share, 0.2);
    this->Legend->SetWidth(0.85 * share);
  }
}

void vtkRegimeMap::SetVisibility(bool visible)
{
  this->Actor->SetVisibility(visible);
  this->Legend->SetVisibility(visible);
  this->Modified();
}

bool vtkRegimeMap::GetVisibility()
{
  return this->Actor->GetVisibility() != 0;
}

vtkActor* vtkRegimeMap::GetBodyActor()
{
  return this->Actor;
}

vtkScalarBarActor* vtkRegimeMap::GetLegend()
{
  return this->Legend;
}

void vtkRegimeMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Quantity: " << this->Quantity << "\n";
  os << indent << "Visibility: " << this->GetVisibility() << "\n";
}
