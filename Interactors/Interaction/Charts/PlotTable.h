// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlotTable_h
#define PlotTable_h

#include "Interaction/Display/DisplayColors.h"

#include "vtkChartXY.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkPlotPoints.h"
#include "vtkTable.h"

#include <limits>
#include <string>

namespace palpate
{
/// A table of two columns, and the line or the marker that shows it in a chart. The table is filled
/// again for each picture. A row of NaN makes a gap in the line.
class PlotTable
{
public:
  PlotTable(const char* x, const char* y)
  {
    this->X->SetName(x);
    this->Y->SetName(y);
    this->Table->AddColumn(this->X);
    this->Table->AddColumn(this->Y);
    this->begin();
    this->end();
  }

  void begin()
  {
    this->X->SetNumberOfValues(0);
    this->Y->SetNumberOfValues(0);
  }
  void add(double x, double y)
  {
    this->X->InsertNextValue(x);
    this->Y->InsertNextValue(y);
  }
  void addGap()
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    this->add(none, none);
  }
  /// Ends the filling. If the table has no rows, adds a row of NaN, so that the curve keeps its
  /// entry in the legend.
  void end()
  {
    if (this->X->GetNumberOfValues() == 0)
    {
      this->addGap();
    }
    this->X->Modified();
    this->Y->Modified();
    this->Table->Modified();
  }

  vtkPlot* addLine(vtkChartXY* chart, const std::string& label, const Color& color, float width,
    int penType = vtkPen::SOLID_LINE)
  {
    return this->addPlot(vtkChart::LINE, chart, label, color, width, penType);
  }
  vtkPlot* addMarker(vtkChartXY* chart, const std::string& label, const Color& color, float size)
  {
    vtkPlot* plot = this->addPlot(vtkChart::POINTS, chart, label, color, size, vtkPen::SOLID_LINE);
    auto* points = vtkPlotPoints::SafeDownCast(plot);
    points->SetMarkerStyle(vtkPlotPoints::CIRCLE);
    points->SetMarkerSize(size);
    plot->SetLegendVisibility(false); // no entry in the legend, where the marker would be too large
    return plot;
  }

private:
  vtkPlot* addPlot(int type, vtkChartXY* chart, const std::string& label, const Color& color,
    float width, int penType)
  {
    vtkPlot* plot = chart->AddPlot(type);
    plot->SetInputData(this->Table, 0, 1);
    plot->GetPen()->SetColorF(color[0], color[1], color[2]);
    plot->GetPen()->SetLineType(penType);
    plot->SetWidth(width);
    plot->SetLabel(label);
    plot->SetLegendVisibility(!label.empty());
    return plot;
  }

  vtkNew<vtkTable> Table;
  vtkNew<vtkDoubleArray> X;
  vtkNew<vtkDoubleArray> Y;
};

/// A table of three columns, with the area between its second and third column (addBand). The table
/// is filled again for each picture. If it has no rows, nothing is drawn.
class BandTable
{
public:
  BandTable(const char* x, const char* least, const char* most)
  {
    this->X->SetName(x);
    this->Least->SetName(least);
    this->Most->SetName(most);
    for (vtkDoubleArray* column : { this->X.Get(), this->Least.Get(), this->Most.Get() })
    {
      this->Table->AddColumn(column);
    }
    this->begin();
    this->end();
  }

  void begin()
  {
    for (vtkDoubleArray* column : { this->X.Get(), this->Least.Get(), this->Most.Get() })
    {
      column->SetNumberOfValues(0);
    }
  }
  void add(double x, double least, double most)
  {
    this->X->InsertNextValue(x);
    this->Least->InsertNextValue(least);
    this->Most->InsertNextValue(most);
  }
  /// Ends the filling. If there are fewer than two rows, adds rows of zeros, because an area needs
  /// two rows.
  void end()
  {
    while (this->X->GetNumberOfValues() < 2)
    {
      this->add(0.0, 0.0, 0.0);
    }
    for (vtkDoubleArray* column : { this->X.Get(), this->Least.Get(), this->Most.Get() })
    {
      column->Modified();
    }
    this->Table->Modified();
  }

  vtkTable* table() { return this->Table; }

private:
  vtkNew<vtkTable> Table;
  vtkNew<vtkDoubleArray> X;
  vtkNew<vtkDoubleArray> Least;
  vtkNew<vtkDoubleArray> Most;
};
} // namespace palpate

#endif
