// SPDX-License-Identifier: BSD-3-Clause
#include "vtkResponseChart.h"

#include "Interaction/Charts/ChartStyle.h"
#include "Interaction/Display/DisplayColors.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr int TitleSize = 20;
constexpr int AxisTitleSize = 17;
constexpr int LabelSize = 15;
constexpr float LineWidth = 3.0F;

/// Returns the largest finite value of a column.
double largestIn(vtkTable* table, vtkIdType column)
{
  double largest = 0.0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const double value = table->GetValue(row, column).ToDouble();
    largest = std::isfinite(value) ? std::max(largest, value) : largest;
  }
  return largest;
}

/// Returns a table with deflection and bounds of the force, from the rows of `table` that have
/// bounds.
vtkSmartPointer<vtkTable> bandOf(vtkTable* table)
{
  auto band = vtkSmartPointer<vtkTable>::New();
  for (const vtkIdType column : { 0, 2, 3 })
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName(table->GetColumnName(column));
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      const double least = table->GetValue(row, 2).ToDouble();
      if (std::isfinite(least) && std::isfinite(table->GetValue(row, 3).ToDouble()))
      {
        values->InsertNextValue(table->GetValue(row, column).ToDouble());
      }
    }
    band->AddColumn(values);
  }
  return band;
}

/// Returns the rows of `table` whose deflection is in [low, high].
vtkSmartPointer<vtkTable> rowsBetween(vtkTable* table, double low, double high)
{
  auto part = vtkSmartPointer<vtkTable>::New();
  for (vtkIdType column = 0; column < 2; ++column)
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName(table->GetColumnName(column));
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      const double depth = table->GetValue(row, 0).ToDouble();
      if (depth >= low && depth <= high)
      {
        values->InsertNextValue(table->GetValue(row, column).ToDouble());
      }
    }
    part->AddColumn(values);
  }
  return part;
}
} // namespace

vtkStandardNewMacro(vtkResponseChart);

vtkResponseChart::vtkResponseChart()
  : Chart(vtkSmartPointer<vtkChartXY>::New())
{
  this->Chart->SetShowLegend(true);
  this->Chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::LEFT);
  this->Chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  this->Chart->GetLegend()->SetLabelSize(LabelSize);
  this->Chart->GetLegend()->SetPadding(8);
  palpate::styleTitle(this->Chart, TitleSize);
  const char* titles[2] = { "Force on the tool (N)", "Deflection (mm)" };
  for (const int side : { vtkAxis::LEFT, vtkAxis::BOTTOM })
  {
    vtkAxis* axis = this->Chart->GetAxis(side);
    palpate::styleAxis(axis, titles[side], AxisTitleSize, LabelSize);
    axis->SetMinimumLimit(0.0);
  }
}

vtkResponseChart::~vtkResponseChart() = default;

vtkChartXY* vtkResponseChart::GetChart()
{
  return this->Chart;
}

void vtkResponseChart::SetTitle(const std::string& title)
{
  palpate::setTitle(this->Chart, title);
  this->Modified();
}

bool vtkResponseChart::AddCurve(vtkTable* table, const std::string& label)
{
  return this->AddCurve(table, label, std::numeric_limits<double>::infinity());
}

bool vtkResponseChart::AddCurve(vtkTable* table, const std::string& label, double validDepth)
{
  if (!table || table->GetNumberOfColumns() < 2)
  {
    vtkErrorMacro(<< "Curve '" << label
                  << "' needs a table with two columns: deflection (mm) and force (N).");
    return false;
  }
  if (table->GetNumberOfColumns() >= 4)
  {
    this->AddBand(table);
  }
  const double lowest = -std::numeric_limits<double>::infinity();
  const double deepest = std::numeric_limits<double>::infinity();
  auto trusted = rowsBetween(table, lowest, validDepth);
  const vtkIdType join = trusted->GetNumberOfRows();
  if (join > 1)
  {
    this->AddLine(trusted, label, vtkPen::SOLID_LINE);
  }
  if (join < table->GetNumberOfRows())
  {
    // The dotted part starts at the last valid row, so that the line has no gap.
    const double from = join > 0 ? table->GetValue(join - 1, 0).ToDouble() : lowest;
    this->AddLine(rowsBetween(table, from, deepest),
      join > 1 ? std::string() : label + " (beyond validity)", vtkPen::DOT_LINE);
  }
  ++this->Curves;
  this->LargestDeflection = std::max(this->LargestDeflection, largestIn(table, 0));
  this->LargestForce = std::max(this->LargestForce, largestIn(table, 1));
  palpate::fitAxis(this->Chart->GetAxis(vtkAxis::BOTTOM), this->LargestDeflection);
  palpate::fitAxis(this->Chart->GetAxis(vtkAxis::LEFT), this->LargestForce);
  this->Modified();
  return true;
}

void vtkResponseChart::AddBand(vtkTable* table)
{
  const vtkSmartPointer<vtkTable> band = bandOf(table);
  if (band->GetNumberOfRows() > 1)
  {
    palpate::addBand(this->Chart, band,
      palpate::CurveColors[static_cast<std::size_t>(this->Curves) % palpate::CurveColors.size()],
      this->HasBand ? "" : "pale: \u00b1 error of each curve");
    this->HasBand = true;
  }
}

void vtkResponseChart::AddLine(vtkTable* table, const std::string& label, int penStyle)
{
  const palpate::Color& color =
    palpate::CurveColors[static_cast<std::size_t>(this->Curves) % palpate::CurveColors.size()];
  vtkPlot* plot = this->Chart->AddPlot(vtkChart::LINE);
  plot->SetInputData(table, 0, 1);
  plot->GetPen()->SetColorF(color[0], color[1], color[2]);
  plot->SetWidth(LineWidth);
  plot->GetPen()->SetLineType(penStyle);
  plot->SetLabel(label);
  plot->SetLegendVisibility(!label.empty());
}

void vtkResponseChart::RemoveAllCurves()
{
  this->Chart->ClearPlots();
  this->Curves = 0;
  this->HasBand = false;
  this->LargestDeflection = 0.0;
  this->LargestForce = 0.0;
  this->Modified();
}

void vtkResponseChart::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Curves: " << this->Curves << "\n";
}
