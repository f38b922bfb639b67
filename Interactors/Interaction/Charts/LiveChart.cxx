// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Charts/LiveChart.h"

#include "Interaction/Charts/ChartStyle.h"
#include "Interaction/Display/DisplayColors.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkRect.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <string>

namespace palpate
{
namespace
{
constexpr int TitleSize = 15;
constexpr int AxisTitleSize = 14;
constexpr int LabelSize = 13;
constexpr int Steps = 5; // largest number of steps of an axis, small enough for a small chart

constexpr double Shape = 1.35; // preferred ratio of width to height of a chart
constexpr float Margin = 6.0F; // margin around a chart, pixels

constexpr int SymbolWidth = 24;      // width of a symbol in the legend, pixels
constexpr double LetterWidth = 0.56; // average width of a letter, as a fraction of the font's size
/// Largest width of a legend that is placed to the right of the data, as a fraction of the chart's
/// width.
constexpr double NarrowLegend = 0.3;

/// Places the legend of a chart with the width `width` (pixels) to the right of the data or above
/// the data.
void placeLegend(vtkChartXY* chart, double width)
{
  std::size_t letters = 0;
  for (vtkIdType i = 0; i < chart->GetNumberOfPlots(); ++i)
  {
    vtkPlot* plot = chart->GetPlot(i);
    if (plot->GetVisible() && plot->GetLegendVisibility())
    {
      letters = std::max(letters, std::string(plot->GetLabel()).size());
    }
  }
  const double needed = SymbolWidth + LetterWidth * LabelSize * static_cast<double>(letters);
  const int side = needed < NarrowLegend * width ? vtkChartLegend::RIGHT : vtkChartLegend::CENTER;
  if (chart->GetLegend()->GetHorizontalAlignment() != side)
  {
    chart->GetLegend()->SetHorizontalAlignment(side);
  }
}

int rowsOf(int count, int columns)
{
  return (count + columns - 1) / columns;
}

int columnsFor(int count, int width, int height)
{
  int best = 1;
  double largest = 0.0;
  for (int columns = 1; columns <= count; ++columns)
  {
    const double size =
      std::min(width / Shape / columns, static_cast<double>(height) / rowsOf(count, columns));
    if (size > largest)
    {
      largest = size;
      best = columns;
    }
  }
  return best;
}
} // namespace

LiveChart::LiveChart(const char* title, const char* across, const char* up)
{
  static_assert(AxisUp == vtkAxis::LEFT && AxisAcross == vtkAxis::BOTTOM, "axes of a vtkChartXY");
  styleTitle(this->Chart, TitleSize);
  this->setTitle(title);
  this->Chart->SetAutoSize(false);
  this->Chart->SetRenderEmpty(true);
  styleAxis(this->Chart->GetAxis(vtkAxis::BOTTOM), across, AxisTitleSize, LabelSize);
  styleAxis(this->Chart->GetAxis(vtkAxis::LEFT), up, AxisTitleSize, LabelSize);
  this->Chart->SetShowLegend(true);
  vtkChartLegend* legend = this->Chart->GetLegend();
  legend->SetInline(false); // outside the data area
  legend->SetVerticalAlignment(vtkChartLegend::TOP);
  legend->SetLabelSize(LabelSize);
  legend->SetSymbolWidth(SymbolWidth);
  legend->SetPadding(4);
  legend->SetDragEnabled(false);
  legend->GetBrush()->SetOpacity(0);
  legend->GetPen()->SetLineType(vtkPen::NO_PEN);
  this->growAcross(1.0);
  this->growUp(1.0);
  this->reset();
}

LiveChart::~LiveChart() = default;

void LiveChart::setTitle(const std::string& title)
{
  palpate::setTitle(this->Chart, title);
}

void LiveChart::grow(int axis, double& end, double largest)
{
  if (largest > end)
  {
    const double fitted = fitAxis(this->Chart->GetAxis(axis), largest, Steps);
    end = fitted > 0.0 ? fitted : end;
  }
}

void LiveChart::fit(int axis, double& end, ScaleRule& rule, double largest, double time)
{
  if (rule.mustChange(largest, end, time))
  {
    end = 0.0;
    this->grow(axis, end, largest);
  }
}

void layOut(const std::vector<vtkChartXY*>& charts, int width, int height)
{
  const int count = static_cast<int>(charts.size());
  if (count == 0)
  {
    return;
  }
  const int columns = columnsFor(count, width, height);
  const int rows = rowsOf(count, columns);
  const float across = static_cast<float>(width) / static_cast<float>(columns);
  const float up = static_cast<float>(height) / static_cast<float>(rows);
  for (int i = 0; i < count; ++i)
  {
    const auto column = static_cast<float>(i % columns);
    const auto row = static_cast<float>(rows - 1 - i / columns);
    charts[static_cast<std::size_t>(i)]->SetSize(
      vtkRectf(column * across + Margin, row * up + Margin, std::max(across - 2.0F * Margin, 1.0F),
        std::max(up - 2.0F * Margin, 1.0F)));
    placeLegend(charts[static_cast<std::size_t>(i)], across - 2.0F * Margin);
  }
}
} // namespace palpate
