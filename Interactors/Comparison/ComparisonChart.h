// SPDX-License-Identifier: BSD-3-Clause
#ifndef ComparisonChart_h
#define ComparisonChart_h

#include "Comparison/RegimeStatement.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPlot;
class vtkRenderWindow;
class vtkRenderer;
class vtkResponseChart;
class vtkTable;

namespace palpate
{
/// A chart with the curves of all tools at one point of a body, the depth of the verdict, and the
/// present point of the shown tool.
class ComparisonChart
{
public:
  ComparisonChart();
  ~ComparisonChart();
  ComparisonChart(const ComparisonChart&) = delete;
  ComparisonChart& operator=(const ComparisonChart&) = delete;

  /// Adds the chart to a part of the window. `viewport` contains left, bottom, right and top as
  /// fractions of the window.
  void addTo(vtkRenderWindow* window, const double (&viewport)[4]);

  /// Draws the curves of a point, and a line at `deflection` (mm). Returns "" or an error message.
  std::string drawCurves(
    vtkPolyData* body, vtkIdType point, const std::vector<ComparedTool>& tools, double deflection);

  /// Moves the marker of the present contact to a deflection (mm) and a force (N). If `deflection`
  /// is 0, the marker is hidden.
  void mark(double deflection, double force);

  vtkResponseChart* chart();

private:
  void drawDepth(double deflection);
  void drawPoint();

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkResponseChart> Chart;
  vtkSmartPointer<vtkTable> Point;
  vtkSmartPointer<vtkPlot> PointPlot;
};
} // namespace palpate

#endif
