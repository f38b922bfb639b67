// SPDX-License-Identifier: BSD-3-Clause
// Reads the data of the live charts from their tables, and makes bodies with a varying response.
#ifndef palpate_testing_LiveChartChecks_h
#define palpate_testing_LiveChartChecks_h

#include "Response/FilterChecks.h"
#include "SceneBodies.h"

#include "vtkChartXY.h"
#include "vtkLiveCharts.h"
#include "vtkPlot.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace palpate::testing
{
using Row = std::pair<double, double>;

/// The rows of a plot; gaps are rows of NaN.
inline std::vector<Row> rowsOf(vtkPlot* plot)
{
  vtkTable* table = plot->GetInput();
  std::vector<Row> rows;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    rows.emplace_back(table->GetValue(row, 0).ToDouble(), table->GetValue(row, 1).ToDouble());
  }
  return rows;
}

/// The visible rows of a plot, without gaps.
inline std::vector<Row> pointsOf(vtkPlot* plot)
{
  std::vector<Row> points;
  for (const Row& row : rowsOf(plot))
  {
    if (std::isfinite(row.first))
    {
      points.push_back(row);
    }
  }
  return points;
}

/// The plot with this label in the legend.
inline vtkPlot* plotOf(vtkChartXY* chart, const std::string& label)
{
  for (vtkIdType i = 0; i < chart->GetNumberOfPlots(); ++i)
  {
    if (std::string(chart->GetPlot(i)->GetLabel()) == label)
    {
      return chart->GetPlot(i);
    }
  }
  std::cerr << "no plot '" << label << "'" << std::endl;
  PALPATE_CHECK(false);
  return chart->GetPlot(0);
}

/// The points of a curve, which consists of the plot with this label and the dotted plot after it.
inline std::vector<Row> curveOf(vtkChartXY* chart, const std::string& label)
{
  vtkPlot* solid = plotOf(chart, label);
  std::vector<Row> points = pointsOf(solid);
  const std::vector<Row> beyond = pointsOf(chart->GetPlot(chart->GetPlotIndex(solid) + 1));
  points.insert(points.end(), beyond.begin(), beyond.end());
  return points;
}

/// A path of (x, y, z, seconds), mm.
inline Body timedPath(std::initializer_list<std::array<double, 4>> way)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  for (const auto& [x, y, z, seconds] : way)
  {
    points->InsertNextPoint(x, y, z);
    time->InsertNextValue(seconds);
  }
  auto path = Body::New();
  path->SetPoints(points);
  path->GetPointData()->AddArray(time);
  return path;
}

/// On a plane z = 0: `depth` mm deep at 0.8 s, then 6 mm along y, outside again at 2.4 s.
inline Body pressAndSlide(double depth)
{
  return timedPath({ { 0.3, 0.2, 1.0, 0.0 }, { 0.3, 0.2, 0.0, 0.4 }, { 0.3, 0.2, -depth, 0.8 },
    { 0.3, 0.2, -depth, 1.0 }, { 0.4, 6.2, -depth, 2.0 }, { 0.4, 6.2, 1.0, 2.4 },
    { 0.4, 6.2, 1.0, 3.2 } });
}

/// Returns the body with the response of a tool. The modulus differs from point to point, 1 to 5
/// MPa; ν = 0.
inline Body unevenResponse(vtkPolyData* body, const std::string& tool)
{
  const auto modulus = [](vtkIdType i)
  { return 3.0 + 2.0 * std::sin(2.0 * static_cast<double>(i)); };
  pointArray(body, "E", modulus);
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(body);
  filter->SetTool(makeTool(tool));
  filter->SetPoissonRatio(0.0);
  makePlain(filter);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "E");
  filter->Update();
  auto copy = Body::New();
  copy->ShallowCopy(filter->GetOutput());
  return copy;
}
} // namespace palpate::testing

#endif
