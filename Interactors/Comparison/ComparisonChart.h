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
/// The curves of all tools at one point of a body, the depth of the verdict, and the shown tool's
/// point on its curve.
class ComparisonChart
{
public:
  ComparisonChart();
  ~ComparisonChart();
  ComparisonChart(const ComparisonChart&) = delete;
  ComparisonChart& operator=(const ComparisonChart&) = delete;

  /// Adds it to a part of the window: left, bottom, right, top as fractions.
  void addTo(vtkRenderWindow* window, const double (&viewport)[4]);

  /// Draws the curves of a point, and a line at `deflection` (mm). Returns what is wrong, or "".
  std::string drawCurves(
    vtkPolyData* body, vtkIdType point, const std::vector<ComparedTool>& tools, double deflection);

  /// The running point, mm and N; hidden without contact.
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
