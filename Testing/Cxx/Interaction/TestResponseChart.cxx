// SPDX-License-Identifier: BSD-3-Clause
// Force over deflection of three tools, dotted beyond validity: the plotted data, and the picture.
#include "Picture.h"
#include "Response/TestBodies.h"

#include "vtkAxis.h"
#include "vtkChartXY.h"
#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkResponseChart.h"
#include "vtkResponseCurves.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <limits>

namespace
{
using namespace palpate::testing;

vtkSmartPointer<vtkTable> curveOf(const char* tool)
{
  vtkNew<vtkResponseCurves> curves;
  curves->SetInputData(withResponse(planeBody(10.0, 4), tool));
  curves->AddPointId(12);
  curves->Update();
  return curves->GetOutput();
}

double columnEnd(vtkPlot* plot, vtkIdType column, bool last)
{
  vtkTable* table = plot->GetInput();
  return table->GetValue(last ? table->GetNumberOfRows() - 1 : 0, column).ToDouble();
}

void checkLine(vtkChartXY* chart, int index, const char* label, int pen, double from, double to)
{
  vtkPlot* plot = chart->GetPlot(index);
  PALPATE_CHECK(plot->GetPen()->GetLineType() == pen);
  PALPATE_CHECK(plot->GetLegendVisibility() == (label[0] != '\0'));
  PALPATE_CHECK(std::string(plot->GetLabel()) == label);
  PALPATE_CHECK_NEAR(columnEnd(plot, 0, false), from, 1e-12);
  PALPATE_CHECK_NEAR(columnEnd(plot, 0, true), to, 1e-12);
}

/// Checks the lines. Rows are 0.02 mm apart, from 0 to 2 mm.
void checkLines(vtkResponseChart* responses)
{
  vtkChartXY* chart = responses->GetChart();
  PALPATE_CHECK(chart->GetNumberOfPlots() == 4);
  checkLine(chart, 0, "flat", vtkPen::SOLID_LINE, 0.0, 2.0); // valid up to the last row
  checkLine(chart, 1, "sphere", vtkPen::SOLID_LINE, 0.0, 1.0);
  checkLine(chart, 2, "", vtkPen::DOT_LINE, 1.0, 2.0); // no gap, no second entry in the legend
  checkLine(chart, 3, "cone (beyond validity)", vtkPen::DOT_LINE, 0.0, 2.0);
  PALPATE_CHECK_NEAR(columnEnd(chart->GetPlot(0), 1, true), 2.0 * 3.45 * 1.6 * 2.0, 1e-3);
  const auto sameColor = [chart](int one, int other)
  {
    double a[3];
    double b[3];
    chart->GetPlot(one)->GetPen()->GetColorF(a);
    chart->GetPlot(other)->GetPen()->GetColorF(b);
    return std::equal(a, a + 3, b);
  };
  PALPATE_CHECK(sameColor(1, 2) && !sameColor(0, 1) && !sameColor(1, 3) && !sameColor(0, 3));
}

void checkAxes(vtkChartXY* chart)
{
  PALPATE_CHECK(std::string(chart->GetAxis(vtkAxis::LEFT)->GetTitle()) == "Force on the tool (N)");
  PALPATE_CHECK(std::string(chart->GetAxis(vtkAxis::BOTTOM)->GetTitle()) == "Deflection (mm)");
  for (const int side : { vtkAxis::LEFT, vtkAxis::BOTTOM })
  {
    vtkAxis* axis = chart->GetAxis(side);
    const double largest = side == vtkAxis::LEFT ? columnEnd(chart->GetPlot(2), 1, true) : 2.0;
    PALPATE_CHECK(axis->GetMinimum() == 0.0);
    PALPATE_CHECK(axis->GetMaximum() >= largest && axis->GetMaximum() <= 1.25 * largest);
    const vtkIdType ticks = axis->GetTickPositions()->GetNumberOfTuples();
    PALPATE_CHECK(ticks >= 4 && ticks <= 12 && axis->GetTickLabels()->GetNumberOfTuples() == ticks);
  }
}

void checkErrors()
{
  vtkNew<vtkResponseChart> chart;
  Messages messages(chart);
  vtkNew<vtkTable> narrow;
  vtkNew<vtkDoubleArray> column;
  column->SetName("Deflection (mm)");
  narrow->AddColumn(column);
  PALPATE_CHECK(!chart->AddCurve(narrow, "narrow"));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "narrow", "two columns");
  PALPATE_CHECK(!chart->AddCurve(nullptr, "none"));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "none", "two columns");
  PALPATE_CHECK(chart->GetChart()->GetNumberOfPlots() == 0);
}
} // namespace

int TestResponseChart(int argc, char* argv[])
{
  checkErrors();
  const auto flat = curveOf("flat:1.6");
  const auto sphere = curveOf("sphere:6.35");
  const auto cone = curveOf("cone:60");
  vtkNew<vtkResponseChart> responses;
  const auto fill = [&](double validDepth)
  {
    responses->RemoveAllCurves();
    PALPATE_CHECK(responses->GetChart()->GetNumberOfPlots() == 0);
    PALPATE_CHECK(responses->AddCurve(flat, "flat"));
    PALPATE_CHECK(responses->AddCurve(sphere, "sphere", validDepth));
    PALPATE_CHECK(responses->AddCurve(cone, "cone", 0.0));
  };
  responses->SetTitle("Three tools");
  vtkNew<vtkContextView> view;
  view->GetRenderWindow()->SetOffScreenRendering(1);
  view->GetRenderWindow()->SetMultiSamples(0);
  view->GetRenderWindow()->SetSize(640, 480);
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  view->GetScene()->AddItem(responses->GetChart());
  fill(1.005);
  checkLines(responses);
  const auto sound = draw(view->GetRenderWindow());
  checkAxes(responses->GetChart());
  checkBaseline(view->GetRenderWindow(), argc, argv);

  fill(2.0);
  checkFaultShows("solid beyond validity", sound, view->GetRenderWindow());
  fill(1.2);
  checkFaultShows("valid to 1.2 mm for 1.0 mm", sound, view->GetRenderWindow());
  fill(1.005);
  checkSound(sound, view->GetRenderWindow()); // no part of the removed curves remains
  responses->GetChart()->GetAxis(vtkAxis::LEFT)->SetTitle("Force on the tool (mN)");
  checkFaultShows("another unit at the axis", sound, view->GetRenderWindow());
  responses->GetChart()->GetAxis(vtkAxis::LEFT)->SetTitle("Force on the tool (N)");
  responses->RemoveAllCurves();
  responses->AddCurve(flat, "flat");
  responses->AddCurve(cone, "cone", 0.0);
  responses->AddCurve(sphere, "sphere", 1.005);
  checkFaultShows("colours exchanged", sound, view->GetRenderWindow());
  return palpate::testing::result();
}
