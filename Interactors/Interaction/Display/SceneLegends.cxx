// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/SceneLegends.h"

#include "Interaction/Display/SceneView.h"

#include "Interaction/Display/DisplayColors.h"
#include "Interaction/Display/RoundSteps.h"
#include "Response/RoundNumber.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace palpate
{
namespace
{
constexpr int LegendSize = 15;
constexpr double LegendWidth = 175.0; // width of the legends, pixels
/// Height below the legends that always remains free, pixels. Therefore the legends do not move
/// when the caption grows.
constexpr double CaptionHeight = 160.0;
constexpr double LegendBottom = 0.15;
constexpr double LegendTop = 0.97;

/// Fills the table with colours that are interpolated between the given colours.
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

const std::string ForceTitle = "Force (N)";
const std::string DisplacementTitle = "Displacement (mm)";

void setLegendTitle(vtkScalarBarActor* legend, const std::string& title)
{
  legend->SetTitle((title + "\n ").c_str()); // the empty line makes a gap above the bar
}

/// Styles a legend: a narrow bar with a title and numbers in `fontSize` points.
void styleLegend(
  vtkScalarBarActor* legend, vtkLookupTable* table, const std::string& title, int fontSize)
{
  legend->SetLookupTable(table);
  setLegendTitle(legend, title);
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

constexpr double Margin = 24.0;       // distance from the right edge, pixels
constexpr double Height = 26.0;       // height of the arrow's axis above the lower edge, pixels
constexpr double HalfShaft = 2.0;     // half width of the shaft, pixels
constexpr double HalfHead = 6.5;      // half width of the head, pixels
constexpr double HeadLength = 14.0;   // length of the head, pixels; at most half of the arrow
constexpr double LabelWidth = 60.0;   // pixels; wider than any label
constexpr double RemarkWidth = 110.0; // width of the remark, pixels
constexpr double LargestShare = 1.0 / 3.0;
} // namespace

SceneLegends::SceneLegends()
{
  fillColors(this->DisplacementColors, DeflectionColors);
  this->DisplacementColors->SetVectorModeToMagnitude();
  fillColors(this->ForceColors, TrailColors);
  styleLegend(this->Displacement, this->DisplacementColors, DisplacementTitle, LegendSize);
  styleLegend(this->Force, this->ForceColors, ForceTitle, LegendSize);
  this->Force->SetLabelFormat("%.4g");
}

SceneLegends::~SceneLegends() = default;

void SceneLegends::setLargestDisplacement(double largest)
{
  this->DisplacementColors->SetTableRange(0.0, largest);
  this->Displacement->SetNumberOfLabels(labelsOfBar(largest));
}

void SceneLegends::setLargestForce(double largest)
{
  this->ForceColors->SetTableRange(0.0, largest);
  this->Force->SetNumberOfLabels(labelsOfBar(largest));
}

void SceneLegends::explainCircle(bool explains)
{
  setLegendTitle(
    this->Displacement, DisplacementTitle + (explains ? "\nblue circle: contact" : ""));
}

void SceneLegends::explainGaps(const std::string& words)
{
  setLegendTitle(this->Force, ForceTitle + (words.empty() ? "" : "\n" + words));
}

double SceneLegends::share(vtkRenderer* renderer)
{
  // The width of the legends in pixels does not depend on the width of the viewport.
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

ForceScale::ForceScale()
  : Shape(vtkSmartPointer<vtkPolyData>::New())
  , Arrow(vtkSmartPointer<vtkActor2D>::New())
  , Label(vtkSmartPointer<vtkTextActor>::New())
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->Shape);
  this->Arrow->SetMapper(mapper);
  this->Arrow->GetProperty()->SetColor(ForceColor[0], ForceColor[1], ForceColor[2]);
  vtkTextProperty* text = this->Label->GetTextProperty();
  text->SetColor(TextColor.data());
  text->SetFontSize(15);
  text->SetJustificationToRight();
}

ForceScale::~ForceScale() = default;

void ForceScale::choose(double largestForce, double scale)
{
  this->Force = roundDown(0.5 * largestForce);
  this->Scale = scale;
}

void ForceScale::setVisibility(bool visible)
{
  this->Arrow->SetVisibility(visible);
  this->Label->SetVisibility(visible);
}

void ForceScale::place(vtkRenderer* renderer, const Eigen::Vector3d& contact)
{
  const double width = renderer->GetSize()[0];
  const double perNewton = this->Scale * pixelsPerMillimetre(renderer, contact);
  if (!std::isfinite(perNewton) || !(perNewton > 0.0))
  {
    return;
  }
  const double most = LargestShare * width / perNewton;
  const double force = this->Force <= most ? this->Force : roundDown(most);
  const double length = force * perNewton;
  this->Width = std::max(length, this->IsChanged ? RemarkWidth : LabelWidth) + Margin;
  const double head = width - Margin;
  const double tail = head - length;
  const double neck = head - std::min(HeadLength, 0.5 * length);
  vtkNew<vtkPoints> corners;
  for (const auto& [x, y] : { std::array{ tail, -HalfShaft }, std::array{ neck, -HalfShaft },
         std::array{ neck, -HalfHead }, std::array{ head, 0.0 }, std::array{ neck, HalfHead },
         std::array{ neck, HalfShaft }, std::array{ tail, HalfShaft } })
  {
    corners->InsertNextPoint(x, Height + y, 0.0);
  }
  // Shaft and head are separate polygons, because their union is not convex.
  vtkNew<vtkCellArray> parts;
  parts->InsertNextCell({ 0, 1, 5, 6 });
  parts->InsertNextCell({ 2, 3, 4 });
  this->Shape->SetPoints(corners);
  this->Shape->SetPolys(parts);
  std::array<char, 32> text{};
  std::snprintf(
    text.data(), text.size(), "%s%.3g N", this->IsChanged ? "scale changed\n" : "", force);
  this->Label->SetInput(text.data());
  this->Label->SetPosition(head, Height + HalfHead + 4.0);
}
} // namespace palpate
