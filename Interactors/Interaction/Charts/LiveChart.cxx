// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Charts/LiveChart.h"

#include "Interaction/Charts/ChartStyle.h"
#include "Interaction/Display/DisplayColors.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkPen.h"
#include "vtkTextProperty.h"

namespace palpate
{
namespace
{
constexpr int TitleSize = 15;
constexpr int AxisTitleSize = 14;
constexpr int LabelSize = 13;
constexpr int Steps = 5; // of an axis, at most: a chart may be small
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
  legend->SetHorizontalAlignment(vtkChartLegend::LEFT);
  legend->SetVerticalAlignment(vtkChartLegend::TOP);
  legend->SetLabelSize(LabelSize);
  legend->SetSymbolWidth(24);
  legend->SetPadding(4);
  legend->SetDragEnabled(false);
  legend->GetBrush()->SetColorF(1.0, 1.0, 1.0, 0.75); // what it covers is seen through it
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
} // namespace palpate
