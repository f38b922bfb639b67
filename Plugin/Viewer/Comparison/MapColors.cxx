// SPDX-License-Identifier: BSD-3-Clause
#include "MapColors.h"

#include "Interaction/Display/RoundSteps.h"
#include "Interaction/Display/SceneView.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr int MapColors = 256;
constexpr int BarTextSize = 15;
constexpr Color PaleTissue = { 0.93, 0.89, 0.84 };
constexpr Color DeepRed = { 0.55, 0.02, 0.10 };
constexpr Color NoResponse = { 0.62, 0.62, 0.64 };

vtkSmartPointer<vtkScalarBarActor> makeBar(
  vtkLookupTable* colors, const std::string& title, const char* labelFormat)
{
  auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(colors);
  bar->SetTitle(title.c_str());
  bar->SetLabelFormat(labelFormat);
  const double* range = colors->GetTableRange();
  bar->SetNumberOfLabels(range[0] == 0.0 ? labelsOfBar(range[1]) : 5);
  bar->SetBarRatio(0.25);
  bar->UnconstrainedFontSizeOn();
  for (vtkTextProperty* text : { bar->GetTitleTextProperty(), bar->GetLabelTextProperty() })
  {
    text->SetColor(TextColor[0], TextColor[1], TextColor[2]);
    text->SetFontSize(BarTextSize);
    text->SetBold(0);
    text->SetItalic(0);
    text->SetShadow(0);
  }
  bar->GetPositionCoordinate()->SetValue(0.77, 0.2);
  bar->SetWidth(0.22);
  bar->SetHeight(0.6);
  return bar;
}
} // namespace

vtkSmartPointer<vtkLookupTable> makeMapColors(const std::array<double, 2>& range, double curve)
{
  auto colors = vtkSmartPointer<vtkLookupTable>::New();
  colors->SetNumberOfTableValues(MapColors);
  colors->SetTableRange(range[0], range[1]);
  for (int i = 0; i < MapColors; ++i)
  {
    const double share = std::pow(static_cast<double>(i) / (MapColors - 1), curve);
    Color color{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      color[k] = (1.0 - share) * PaleTissue[k] + share * DeepRed[k];
    }
    colors->SetTableValue(i, color[0], color[1], color[2]);
  }
  colors->SetNanColor(NoResponse[0], NoResponse[1], NoResponse[2], 1.0);
  return colors;
}

void addColoredBody(vtkPolyData* body, vtkLookupTable* colors, const std::string& title,
  const char* labelFormat, vtkRenderer* renderer)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(body);
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  // The shading is weak, so that colours can be compared with those of the legend.
  actor->GetProperty()->SetAmbient(0.55);
  actor->GetProperty()->SetDiffuse(0.45);
  actor->GetProperty()->SetSpecular(0.0);
  renderer->AddActor(actor);
  renderer->AddViewProp(makeBar(colors, title, labelFormat));
}
} // namespace palpate
