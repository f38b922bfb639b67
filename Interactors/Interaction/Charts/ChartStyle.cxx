// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Charts/ChartStyle.h"

#include "Interaction/Display/DisplayColors.h"
#include "Interaction/Display/RoundSteps.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChart.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkPlotArea.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace palpate
{
namespace
{
// Distance between the title and the frame, as a fraction of the line height.
constexpr double TitleGap = 0.4;

std::string textOf(double value)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

/// Places axis ticks at the integer multiples of `step` from `first` to `last`. `label` returns the
/// text of the tick with the given integer.
template <class Label>
void setTicks(vtkAxis* axis, int first, int last, double step, const Label& label)
{
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (int i = first; i <= last; ++i)
  {
    positions->InsertNextValue(i * step);
    labels->InsertNextValue(label(i));
  }
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetCustomTickPositions(positions, labels);
}
} // namespace

const char* const BandLabel = "\u00b1 error";

double fitAxis(vtkAxis* axis, double largest, int steps)
{
  if (!(largest > 0.0) || !std::isfinite(largest))
  {
    return 0.0;
  }
  const double step = roundStep(largest, steps);
  const int last = static_cast<int>(std::ceil(largest / step - 1e-9));
  setTicks(axis, 0, last, step, [step](int i) { return textOf(i * step); });
  axis->SetRange(0.0, last * step);
  return last * step;
}

void fitAxisBefore(vtkAxis* axis, double span, int steps)
{
  const double step = roundStep(span, steps);
  const int first = -static_cast<int>(std::floor(span / step + 1e-9));
  setTicks(axis, first, 0, step, [step](int i) { return textOf(i * step); });
  axis->SetRange(-span, 0.0);
}

void fitLogAxis(vtkAxis* axis, int first, int last, double below)
{
  setTicks(axis, first, last, 1.0,
    [](int i) { return i > 3 ? "1e" + std::to_string(i) : textOf(std::pow(10.0, i)); });
  axis->SetRange(first - below, last);
}

void styleAxis(vtkAxis* axis, const char* title, int titleSize, int labelSize)
{
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(titleSize);
  axis->GetTitleProperties()->SetBold(0);
  axis->GetLabelProperties()->SetFontSize(labelSize);
}

void styleTitle(vtkChart* chart, int size)
{
  vtkTextProperty* text = chart->GetTitleProperties();
  text->SetFontSize(size);
  text->SetColor(TextColor.data());
  text->SetLineSpacing(TitleGap);
}

void setTitle(vtkChart* chart, const std::string& title)
{
  // The empty line makes a gap between the title and the chart.
  chart->SetTitle(title.empty() ? title : title + "\n ");
}

void addBand(vtkChart* chart, vtkTable* table, const Color& color, const std::string& label)
{
  constexpr double Opacity = 0.22;
  auto* area = vtkPlotArea::SafeDownCast(chart->AddPlot(vtkChart::AREA));
  area->SetInputData(table);
  for (int column = 0; column < 3; ++column)
  {
    area->SetInputArray(column, table->GetColumnName(column));
  }
  area->GetBrush()->SetColorF(color[0], color[1], color[2], Opacity);
  area->GetPen()->SetLineType(vtkPen::NO_PEN);
  area->SetLabel(label);
  area->SetLegendVisibility(!label.empty());
}
} // namespace palpate
